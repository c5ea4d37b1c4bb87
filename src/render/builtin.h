/* SPDX-License-Identifier: Apache-2.0 */
/* Meshes that need no file. */
#ifndef ND_RENDER_BUILTIN_H
#define ND_RENDER_BUILTIN_H
#include "io/mesh.h"

/* Whether a built-in mesh has that name. */
bool nd_builtin_is(const char *name);

/* Makes it: vertex normals, tangents and texture coordinates are those of the smooth surface.
   Errors:   false with NDL_E_MEMORY. */
bool nd_builtin_mesh(const char *name, nd_mesh *m, ndl_error *error);

#endif
