/* SPDX-License-Identifier: Apache-2.0 */
/* Expressions as text: one parser for materials, lights, cameras and tone maps.

       expr   = lobe { "+" lobe }
       lobe   = [ weight "*" ] call
       call   = name [ "(" [ key "=" value { "," key "=" value } ] ")" ]
       weight = number | rgb
       value  = number | rgb | word | ramp | vector
       rgb    = number | "[" number "," number "," number "]" | "#rrggbb"
       ramp   = "[" number ":" rgb { "," number ":" rgb } "]"

   The parser knows the grammar and nothing of models: names get their meaning in bind.h. */
#ifndef ND_CORE_EXPR_H
#define ND_CORE_EXPR_H
#include "base/arena.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>

typedef enum { ND_NUMBER, ND_TRIPLE, ND_HEX, ND_WORD, ND_RAMP } nd_value_kind;

typedef struct {
    nd_value_kind kind;
    int column;
    float v[3];       /* number: v[0]; triple and hex colour (decoded to linear): all */
    const char *word; /* ND_WORD */
    int stops;        /* ND_RAMP: positions x and colours r, g, b of so many stops */
    float *x, *r, *g, *b;
} nd_value;

typedef struct {
    const char *key;
    int column;
    nd_value value;
} nd_arg;

typedef struct {
    const char *name;
    int column;
    bool weighted;
    nd_value weight;
    nd_arg *args;
    int arg_count;
} nd_call;

typedef struct {
    nd_call *calls;
    int count;
} nd_expr;

/* Reads text into e, allocating from a. On failure e is unusable and *error says why; what was
   allocated goes with the arena either way. */
bool nd_expr_parse(const char *text, nd_arena *a, nd_expr *e, ndl_error *error);

#endif
