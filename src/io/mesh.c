/* SPDX-License-Identifier: Apache-2.0 */
#include "io/mesh.h"

#include "base/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Beyond it the square of a distance would leave the range of float. */
static const float FARTHEST = 1e15f;

/* Bytes of a packed mesh, or 0 when it is too large to be one. */
static size_t packed_size(uint64_t vertices, uint64_t triangles, uint64_t parts, bool tangents) {
    const uint64_t most = 1u << 31;
    if (vertices >= most || triangles >= most || parts > (1u << 20)) return 0;
    uint64_t size = sizeof(nd_mesh_head) + parts * sizeof(nd_part) +
                    vertices * (tangents ? 11 : 8) * sizeof(float) +
                    triangles * 3 * sizeof(uint32_t);
    return size > SIZE_MAX / 2 ? 0 : (size_t)size;
}

static void place(nd_mesh *m, void *storage, bool tangents) {
    unsigned char *at = (unsigned char *)storage + sizeof(nd_mesh_head);
    m->storage = storage;
    m->part = (nd_part *)(void *)at;
    at += m->parts * sizeof *m->part;
    m->position = (float *)(void *)at;
    m->normal = m->position + 3 * (size_t)m->vertices;
    m->uv = m->normal + 3 * (size_t)m->vertices;
    m->index = (uint32_t *)(void *)(m->uv + 2 * (size_t)m->vertices);
    m->tangent = tangents ? (float *)(void *)(m->index + 3 * (size_t)m->triangles) : NULL;
}

bool nd_mesh_new(nd_mesh *m, size_t vertices, size_t triangles, size_t parts, bool with_tangents) {
    size_t size = packed_size(vertices, triangles, parts, with_tangents);
    void *storage = size ? calloc(1, size) : NULL;
    *m = (nd_mesh){.vertices = (uint32_t)vertices,
                   .triangles = (uint32_t)triangles,
                   .parts = (uint32_t)parts};
    if (!storage) return false;
    place(m, storage, with_tangents);
    return true;
}

void nd_mesh_free(nd_mesh *m) {
    free(m->storage);
    *m = (nd_mesh){0};
}

static float factor(float x, float otherwise) {
    return isfinite(x) ? fminf(fmaxf(x, 0.0f), 1.0f) : otherwise;
}

/* Ends names and bounds factors; false unless the parts cover the triangles without a gap. */
static bool tidy_parts(nd_mesh *m) {
    uint64_t next = 0;
    for (uint32_t i = 0; i < m->parts; i++) {
        nd_part *p = &m->part[i];
        if (p->first != next) return false;
        next += p->count;
        p->mesh[ND_NAME - 1] = p->node[ND_NAME - 1] = p->material[ND_NAME - 1] = '\0';
        for (int c = 0; c < 3; c++) p->base_color[c] = factor(p->base_color[c], 1.0f);
        p->metalness = factor(p->metalness, 1.0f);
        p->roughness = factor(p->roughness, 1.0f);
    }
    return next == m->triangles;
}

static bool tidy_vertices(nd_mesh *m, ndl_error *error) {
    for (size_t i = 0; i < 3 * (size_t)m->vertices; i++) {
        if (!isfinite(m->position[i]))
            return nd_fail(error, NDL_E_FILE, 0, "has a vertex position that is not finite", NULL);
        if (fabsf(m->position[i]) > FARTHEST)
            return nd_fail(error, NDL_E_FILE, 0, "has a vertex position beyond 1e15", NULL);
    }
    for (size_t i = 0; i < m->vertices; i++) {
        float *n = m->normal + 3 * i, *uv = m->uv + 2 * i;
        if (!(isfinite(n[0]) && isfinite(n[1]) && isfinite(n[2]))) n[0] = n[1] = n[2] = 0.0f;
        if (!(isfinite(uv[0]) && isfinite(uv[1]))) uv[0] = uv[1] = 0.0f;
    }
    return true;
}

static bool has_area(const nd_mesh *m, const uint32_t *index) {
    const float *a = m->position + 3 * (size_t)index[0], *b = m->position + 3 * (size_t)index[1];
    const float *c = m->position + 3 * (size_t)index[2];
    double p[3], q[3];
    for (int i = 0; i < 3; i++) {
        p[i] = (double)b[i] - (double)a[i];
        q[i] = (double)c[i] - (double)a[i];
    }
    return p[1] * q[2] != p[2] * q[1] || p[2] * q[0] != p[0] * q[2] || p[0] * q[1] != p[1] * q[0];
}

/* Drops triangles without an area, such as the collapsed ones at the poles of many models. */
static bool tidy_triangles(nd_mesh *m, ndl_error *error) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < m->parts; i++) {
        nd_part *p = &m->part[i];
        uint32_t first = kept;
        for (uint32_t t = p->first; t < p->first + p->count; t++) {
            uint32_t *index = m->index + 3 * (size_t)t;
            for (int k = 0; k < 3; k++)
                if (index[k] >= m->vertices)
                    return nd_fail(error, NDL_E_FILE, 0, "has a face with a vertex that is missing",
                                   NULL);
            if (has_area(m, index))
                memmove(m->index + 3 * (size_t)kept++, index, 3 * sizeof *index);
        }
        p->first = first;
        p->count = kept - first;
    }
    m->triangles = kept;
    if (kept) return true;
    return nd_fail(error, NDL_E_FILE, 0, "has no triangle with an area", NULL);
}

static bool malformed(ndl_error *error) {
    return nd_fail(error, NDL_E_FILE, 0, "the importer gave no mesh; the file is malformed", NULL);
}

static bool refused(const unsigned char *bytes, size_t size, ndl_error *error) {
    char room[200];
    size_t skip = sizeof(uint32_t);
    return nd_fail(error, NDL_E_FILE, 0, "is not a mesh that can be read: ",
                   nd_quote((const char *)bytes + skip, size - skip, room, sizeof room), NULL);
}

bool nd_mesh_unpack(unsigned char *bytes, size_t size, nd_mesh *m, ndl_error *error) {
    nd_mesh_head head = {0};
    *m = (nd_mesh){0};
    if (bytes) memcpy(&head, bytes, size < sizeof head ? size : sizeof head);
    bool is_mesh = head.magic == ND_MESH_MAGIC &&
                   size == packed_size(head.vertices, head.triangles, head.parts, false);
    if (!is_mesh) {
        bool says_why = head.magic == ND_MESH_REFUSED && size > sizeof head.magic;
        bool result = says_why ? refused(bytes, size, error) : malformed(error);
        free(bytes);
        return result;
    }
    *m = (nd_mesh){
        .vertices = head.vertices, .triangles = head.triangles, .parts = head.parts};
    place(m, bytes, false);
    if ((tidy_parts(m) ? true : malformed(error)) && tidy_vertices(m, error) &&
        tidy_triangles(m, error))
        return true;
    nd_mesh_free(m);
    return false;
}
