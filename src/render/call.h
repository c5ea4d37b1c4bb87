/* SPDX-License-Identifier: Apache-2.0 */
/* One call among several kinds: lights, cameras, tone maps. */
#ifndef ND_RENDER_CALL_H
#define ND_RENDER_CALL_H
#include "core/schema.h"

/* Reads `text` as one call of one of the schemas (ended by NULL) and fills `fields`, which has room
   for the largest of their structs. `what` names the kind in messages: "light". Returns the number
   of the schema, or -1 with *error filled. The binding lives as long as the arena. */
int nd_call_parse(const char *text, const char *what, const nd_schema *const *schemas,
                  nd_arena *arena, nd_binding *binding, void *fields, ndl_error *error);

/* Whether `key` was given; otherwise the error that it is needed. */
bool nd_call_needs(nd_binding *binding, const char *key);

/* A colour: a number, [r, g, b] or #rrggbb. Errors: false, with the column. */
bool nd_color_parse(const char *text, ndl_rgb *color, ndl_error *error);

#endif
