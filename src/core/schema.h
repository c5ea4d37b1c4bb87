/* SPDX-License-Identifier: Apache-2.0 */
/* Parameter tables: what keys a model, light, camera or tone map has.

   One X-macro list per owner, NAME_PARAMS(P), with rows P(kind, ...). From it come the struct of
   fields (FIELD), the table of keys (ND_ROW) and the offsets (ND_OFFSET). Kinds with a field:
       NUM(key, low, high, initial, unit, feel)         a number in [low, high]
       NUM_ABOVE(...)                                   the same, low itself excluded
       ANGLE(key, low, high, initial, feel)             radians; key_deg exists by itself
       RGB(key, low, high, initial grey, unit, feel)    a colour; RGB_ABOVE likewise
       VECTOR(key, x, y, z, unit, feel)                 three numbers, defaults x y z
       RAMP(key, feel)                                  a table1
       HIDDEN(field, initial, what), TABLE2(field, what)  fields without a key
   without one:
       CHOICE(key, words, initial word, feel)           a word; its number selects the kernel
       SPELL(key, low, high, initial, group, unit, feel), SPELL_ABOVE, SPELL_ANGLE(no unit),
       SPELL_CHOICE(key, words, initial word, group, feel), SPELL_WORD(key, group, feel)
                                                        another way to give what `group` sets
       GROUP(group)                                     the group's resolver is nd_group_<group> */
#ifndef ND_CORE_SCHEMA_H
#define ND_CORE_SCHEMA_H
#include "core/expr.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct nd_binding nd_binding;

/* Fields that several keys spell. resolve() reads what was given (nd_given) and writes fields;
   false: nd_fail or nd_conflict has said why. `fields` are the keys of its fields, by blanks. */
typedef struct {
    const char *name;
    bool (*resolve)(nd_binding *b);
    const char *fields;
} nd_group;

typedef struct {
    const char *name;
    const ndl_param *params;
    const short *offsets; /* of each key's field in the struct; -1 for none */
    size_t count;
    const nd_group *const *groups; /* ended by NULL */
    size_t size;                   /* of the struct of fields, bytes */
} nd_schema;

enum { ND_MOST_PARAMS = 40 };

struct nd_binding {
    const nd_schema *schema;
    const nd_call *call;
    const nd_arg *given[ND_MOST_PARAMS]; /* by parameter; NULL where not given */
    int choice[ND_MOST_PARAMS];          /* number of the word, for choices */
    unsigned char *fields;               /* the struct being filled */
    nd_arena *arena;                     /* for tables that fields point to */
    ndl_error *error;
    const char *clash[2];                /* keys of the conflict that failed the binding */
};

/* Gives every field of the struct its value from the call's arguments: defaults first, then what
   was given, then the groups. What the fields point to lives in the arena and in the call.
   False with b->error filled. */
bool nd_bind(nd_binding *b, const nd_schema *schema, const nd_call *call, void *fields,
             nd_arena *arena, ndl_error *error);

/* For resolvers and readers of a finished binding; key must be one of the schema's. */
const nd_arg *nd_given(const nd_binding *b, const char *key);
float nd_number(const nd_binding *b, const char *key); /* given, or the key's default */
int nd_choice(const nd_binding *b, const char *key);
void nd_choose(nd_binding *b, const char *key, int value);
void nd_set(nd_binding *b, const char *field_key, const float *values, int count);
/* "a and b exclude each other": fails when both are given. */
bool nd_exclusive(nd_binding *b, const char *a, const char *other, const char *why);

/* Index of a key ("sigma_deg" finds sigma), or -1; *degrees says which of the two it was. */
int nd_key(const nd_schema *s, const char *key, bool *degrees);

/* The number of a word in a blank-separated list, or -1. */
int nd_word_index(const char *words, const char *word);

/* ---- what the rows become -------------------------------------------------------------------- */

#define FIELD(kind, ...) FIELD_##kind(__VA_ARGS__)
#define FIELD_NUM(key, ...) num key;
#define FIELD_NUM_ABOVE(key, ...) num key;
#define FIELD_ANGLE(key, ...) num key;
#define FIELD_RGB(key, ...) vec3 key;
#define FIELD_RGB_ABOVE(key, ...) vec3 key;
#define FIELD_VECTOR(key, ...) vec3 key;
#define FIELD_RAMP(key, ...) table1 key;
#define FIELD_HIDDEN(key, ...) num key;
#define FIELD_TABLE2(key, ...) table2 key;
#define FIELD_CHOICE(...)
#define FIELD_SPELL(...)
#define FIELD_SPELL_ABOVE(...)
#define FIELD_SPELL_ANGLE(...)
#define FIELD_SPELL_CHOICE(...)
#define FIELD_SPELL_WORD(...)
#define FIELD_GROUP(...)

#define ND_NONE {(double)NAN, (double)NAN, (double)NAN}
#define ND_ROW(kind, ...) ND_ROW_##kind(__VA_ARGS__)
#define ND_ROW_NUM(key, lo, hi, def, unit, feel) \
    {#key, unit, feel, NDL_KIND_NUMBER, 0, 0, NULL, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_NUM_ABOVE(key, lo, hi, def, unit, feel) \
    {#key, unit, feel, NDL_KIND_NUMBER, 1, 0, NULL, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_ANGLE(key, lo, hi, def, feel) ND_ROW_NUM(key, lo, hi, def, "rad", feel)
#define ND_ROW_RGB(key, lo, hi, def, unit, feel) \
    {#key, unit, feel, NDL_KIND_COLOR, 0, 0, NULL, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_RGB_ABOVE(key, lo, hi, def, unit, feel) \
    {#key, unit, feel, NDL_KIND_COLOR, 1, 0, NULL, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_VECTOR(key, x, y, z, unit, feel) \
    {#key, unit, feel, NDL_KIND_VECTOR, 0, 0, NULL, -3e38, 3e38, {x, y, z}, NULL, NULL},
#define ND_ROW_RAMP(key, feel) \
    {#key, "1", feel, NDL_KIND_RAMP, 0, 0, NULL, -3e38, 3e38, ND_NONE, NULL, NULL},
#define ND_ROW_CHOICE(key, words, def, feel) \
    {#key, "", feel, NDL_KIND_CHOICE, 0, 0, NULL, 0, 0, ND_NONE, words, #def},
#define ND_ROW_SPELL(key, lo, hi, def, group, unit, feel) \
    {#key, unit, feel, NDL_KIND_NUMBER, 0, 1, #group, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_SPELL_ABOVE(key, lo, hi, def, group, unit, feel) \
    {#key, unit, feel, NDL_KIND_NUMBER, 1, 1, #group, lo, hi, {def, def, def}, NULL, NULL},
#define ND_ROW_SPELL_ANGLE(key, lo, hi, def, group, feel) \
    ND_ROW_SPELL(key, lo, hi, def, group, "rad", feel)
#define ND_ROW_SPELL_CHOICE(key, words, def, group, feel) \
    {#key, "", feel, NDL_KIND_CHOICE, 0, 1, #group, 0, 0, ND_NONE, words, #def},
#define ND_ROW_SPELL_WORD(key, group, feel) \
    {#key, "", feel, NDL_KIND_WORD, 0, 1, #group, 0, 0, ND_NONE, NULL, NULL},
#define ND_ROW_HIDDEN(...)
#define ND_ROW_TABLE2(...)
#define ND_ROW_GROUP(...)

/* Offsets need a type named `owner`: the struct of the list. */
#define ND_OFFSET(kind, ...) ND_OFFSET_##kind(__VA_ARGS__)
#define ND_OFFSET_NUM(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_NUM_ABOVE(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_ANGLE(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_RGB(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_RGB_ABOVE(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_VECTOR(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_RAMP(key, ...) (short)offsetof(owner, key),
#define ND_OFFSET_CHOICE(...) -1,
#define ND_OFFSET_SPELL(...) -1,
#define ND_OFFSET_SPELL_ABOVE(...) -1,
#define ND_OFFSET_SPELL_ANGLE(...) -1,
#define ND_OFFSET_SPELL_CHOICE(...) -1,
#define ND_OFFSET_SPELL_WORD(...) -1,
#define ND_OFFSET_HIDDEN(...)
#define ND_OFFSET_TABLE2(...)
#define ND_OFFSET_GROUP(...)

#define ND_GROUP_OF(kind, ...) ND_GROUP_OF_##kind(__VA_ARGS__)
#define ND_GROUP_OF_GROUP(group) &nd_group_##group,
#define ND_GROUP_OF_NUM(...)
#define ND_GROUP_OF_NUM_ABOVE(...)
#define ND_GROUP_OF_ANGLE(...)
#define ND_GROUP_OF_RGB(...)
#define ND_GROUP_OF_RGB_ABOVE(...)
#define ND_GROUP_OF_VECTOR(...)
#define ND_GROUP_OF_RAMP(...)
#define ND_GROUP_OF_CHOICE(...)
#define ND_GROUP_OF_SPELL(...)
#define ND_GROUP_OF_SPELL_ABOVE(...)
#define ND_GROUP_OF_SPELL_ANGLE(...)
#define ND_GROUP_OF_SPELL_CHOICE(...)
#define ND_GROUP_OF_SPELL_WORD(...)
#define ND_GROUP_OF_HIDDEN(...)
#define ND_GROUP_OF_TABLE2(...)

/* Defines `const nd_schema *function(void)` of a list whose struct is `struct_type`. */
#define ND_DEFINE_SCHEMA(function, schema_name, LIST, struct_type)                                 \
    static const nd_schema *function(void) {                                                      \
        typedef struct_type owner;                                                                \
        static const ndl_param params[] = {LIST(ND_ROW){0}};                                      \
        static const short offsets[] = {LIST(ND_OFFSET) - 1};                                     \
        static const nd_group *const groups[] = {LIST(ND_GROUP_OF) NULL};                         \
        static const nd_schema schema = {schema_name, params,                                     \
                                         offsets,     sizeof params / sizeof *params - 1,         \
                                         groups,      sizeof(owner)};                             \
        return &schema;                                                                           \
    }

#endif
