/* SPDX-License-Identifier: Apache-2.0 */
/* Triangle meshes, and their files. */
#ifndef ND_IO_MESH_H
#define ND_IO_MESH_H
#include "base/process.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { ND_NAME = 96 }; /* bytes of a part's name, the terminator included; longer ones are cut */

/* Triangles of one material. */
typedef struct {
    char mesh[ND_NAME], node[ND_NAME], material[ND_NAME]; /* "" where the file gives none */
    uint32_t first, count; /* its triangles */
    uint32_t has_factors;  /* 1: the glTF factors below are the file's */
    float base_color[3], metalness, roughness; /* in [0, 1] */
} nd_part;

/* All positions are finite, every triangle has an area, every index is below `vertices`. A normal
   of zero means none is known; equal texture coordinates mean that there are none. */
typedef struct {
    uint32_t vertices, triangles, parts;
    nd_part *part;
    float *position, *normal; /* 3 floats a vertex */
    float *uv;                /* 2 floats a vertex */
    float *tangent;           /* 3 floats a vertex, or NULL: to be found from uv */
    uint32_t *index;          /* 3 a triangle, the parts' one after another */
    void *storage;            /* what all of these point into */
} nd_mesh;

/* Room for a mesh, zeroed; false when memory is out. */
bool nd_mesh_new(nd_mesh *m, size_t vertices, size_t triangles, size_t parts, bool with_tangents);
void nd_mesh_free(nd_mesh *m);

/* Imports a mesh file of any format that assimp knows, in a child process under `limits`. Node
   transforms are applied. Where the file has no normals each triangle gets its own; materials keep
   their glTF metallic-roughness factors, not their textures.
   Errors:   NDL_E_FILE (missing, malformed, without a triangle that has an area, with a position
             that is not finite or beyond 1e15), NDL_E_LIMIT, NDL_E_CANCELLED, NDL_E_MEMORY. */
bool nd_mesh_import(const char *path, nd_limits limits, nd_mesh *m, ndl_error *error);

/* Makes a mesh of what the child of nd_mesh_import wrote, taking over `bytes` (malloc). Nothing in
   it is trusted. */
bool nd_mesh_unpack(unsigned char *bytes, size_t size, nd_mesh *m, ndl_error *error);

/* The head of that message; then the parts, positions, normals, texture coordinates, indices. */
typedef struct { uint32_t magic, vertices, triangles, parts; } nd_mesh_head;
enum { ND_MESH_MAGIC = 0x6d657368, ND_MESH_REFUSED = 0x6e6f6e65 }; /* "mesh", "none" + a reason */

#endif
