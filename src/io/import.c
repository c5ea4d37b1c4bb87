/* SPDX-License-Identifier: Apache-2.0 */
/* Mesh files through assimp. Everything up to nd_mesh_import runs in the child process: a crash or
   an endless loop of a parser ends there. */
#include "io/mesh.h"

#include "base/error.h"
#include "base/file.h"

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <math.h>
#include <string.h>

typedef struct { double m[3][4]; } affine;

typedef struct {
    const struct aiScene *scene;
    nd_mesh mesh;
    size_t vertices, triangles, parts; /* counted, then filled */
} flattening;

static affine compose(const affine *a, const struct aiMatrix4x4 *b) {
    const double r[4][4] = {
        {(double)b->a1, (double)b->a2, (double)b->a3, (double)b->a4},
        {(double)b->b1, (double)b->b2, (double)b->b3, (double)b->b4},
        {(double)b->c1, (double)b->c2, (double)b->c3, (double)b->c4},
        {0.0, 0.0, 0.0, 1.0},
    };
    affine c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            c.m[i][j] = 0.0;
            for (int k = 0; k < 4; k++) c.m[i][j] += a->m[i][k] * r[k][j];
        }
    return c;
}

/* The matrix of normals: cofactors of the linear part, with the sign of its determinant, so that a
   mirrored mesh keeps its outside. Returns that sign. */
static double normal_matrix(const affine *a, double n[3][3]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            n[i][j] = a->m[i1][j1] * a->m[i2][j2] - a->m[i1][j2] * a->m[i2][j1];
        }
    double det = a->m[0][0] * n[0][0] + a->m[0][1] * n[0][1] + a->m[0][2] * n[0][2];
    double sign = det < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 9; i++) n[i / 3][i % 3] *= sign;
    return sign;
}

static void store_unit(const double v[3], float *to) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++) to[i] = length > 0.0 ? (float)(v[i] / length) : 0.0f;
}

static void store_position(const affine *a, const struct aiVector3D *p, float *to) {
    for (int i = 0; i < 3; i++)
        to[i] = (float)(a->m[i][0] * (double)p->x + a->m[i][1] * (double)p->y +
                        a->m[i][2] * (double)p->z + a->m[i][3]);
}

static size_t triangles_of(const struct aiMesh *from) {
    size_t n = 0;
    for (unsigned f = 0; f < from->mNumFaces; f++) n += from->mFaces[f].mNumIndices == 3;
    return n;
}

static void count_node(flattening *f, const struct aiNode *node) {
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *from = f->scene->mMeshes[node->mMeshes[i]];
        size_t triangles = triangles_of(from);
        f->triangles += triangles;
        f->vertices += from->mNormals ? from->mNumVertices : 3 * triangles;
        f->parts++;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) count_node(f, node->mChildren[i]);
}

static void copy_name(char to[ND_NAME], const struct aiString *name) {
    size_t n = name->length < ND_NAME - 1 ? name->length : ND_NAME - 1;
    memcpy(to, name->data, n);
    to[n] = '\0';
}

/* One number of a material; false where it has none of that key. (aiGetMaterialFloat is an inline
   function of C99, which unoptimised code cannot link with.) */
static bool number_of(const struct aiMaterial *material, const char *key, float *to) {
    unsigned count = 1;
    return aiGetMaterialFloatArray(material, key, 0, 0, to, &count) == aiReturn_SUCCESS;
}

static void describe(nd_part *part, const struct aiMesh *from, const struct aiNode *node,
                     const struct aiMaterial *material) {
    struct aiString name = {0};
    struct aiColor4D color;
    copy_name(part->mesh, &from->mName);
    copy_name(part->node, &node->mName);
    if (aiGetMaterialString(material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS)
        copy_name(part->material, &name);
    part->has_factors =
        aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &color) == aiReturn_SUCCESS &&
        number_of(material, "$mat.metallicFactor", &part->metalness) &&
        number_of(material, "$mat.roughnessFactor", &part->roughness);
    if (part->has_factors) memcpy(part->base_color, &color, sizeof part->base_color);
}

static void store_vertex(flattening *f, size_t to, const affine *a, double normals[3][3],
                         const struct aiMesh *from, unsigned v) {
    store_position(a, &from->mVertices[v], f->mesh.position + 3 * to);
    if (from->mNormals) {
        const struct aiVector3D *n = &from->mNormals[v];
        double turned[3];
        for (int i = 0; i < 3; i++)
            turned[i] = normals[i][0] * (double)n->x + normals[i][1] * (double)n->y +
                        normals[i][2] * (double)n->z;
        store_unit(turned, f->mesh.normal + 3 * to);
    }
    if (from->mTextureCoords[0]) {
        f->mesh.uv[2 * to] = from->mTextureCoords[0][v].x;
        f->mesh.uv[2 * to + 1] = from->mTextureCoords[0][v].y;
    }
}

/* The normal of the triangle whose three vertices end at f->vertices, for each of them. */
static void store_facet_normal(flattening *f, double sign) {
    const float *p = f->mesh.position + 3 * (f->vertices - 3);
    float *n = f->mesh.normal + 3 * (f->vertices - 3);
    double a[3], b[3], c[3];
    for (int i = 0; i < 3; i++) {
        a[i] = sign * ((double)p[3 + i] - (double)p[i]);
        b[i] = (double)p[6 + i] - (double)p[i];
    }
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    for (int k = 0; k < 3; k++) store_unit(c, n + 3 * k);
}

static void fill_part(flattening *f, const affine *a, const struct aiMesh *from) {
    double normals[3][3];
    double sign = normal_matrix(a, normals);
    size_t first = f->vertices;
    for (unsigned v = 0; from->mNormals && v < from->mNumVertices; v++)
        store_vertex(f, f->vertices++, a, normals, from, v);
    for (unsigned t = 0; t < from->mNumFaces; t++) {
        const struct aiFace *face = &from->mFaces[t];
        if (face->mNumIndices != 3) continue;
        uint32_t *to = f->mesh.index + 3 * f->triangles++;
        for (int k = 0; k < 3; k++) {
            unsigned v = face->mIndices[k];
            if (from->mNormals) {
                to[k] = (uint32_t)(first + v);
            } else {
                to[k] = (uint32_t)f->vertices;
                store_vertex(f, f->vertices++, a, normals, from, v);
            }
        }
        if (!from->mNormals) store_facet_normal(f, sign);
    }
}

static void fill_node(flattening *f, const struct aiNode *node, const affine *parent) {
    affine a = compose(parent, &node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const struct aiMesh *from = f->scene->mMeshes[node->mMeshes[i]];
        nd_part *part = &f->mesh.part[f->parts++];
        describe(part, from, node, f->scene->mMaterials[from->mMaterialIndex]);
        part->first = (uint32_t)f->triangles;
        fill_part(f, &a, from);
        part->count = (uint32_t)f->triangles - part->first;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) fill_node(f, node->mChildren[i], &a);
}

static int refuse(int out, const char *why) {
    uint32_t magic = ND_MESH_REFUSED;
    bool sent = nd_child_write(out, &magic, sizeof magic) && nd_child_write(out, why, strlen(why));
    return sent ? 0 : 1;
}

/* Flattens a scene and sends it; the child's result. */
static int send_scene(const struct aiScene *scene, int out) {
    static const affine identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    flattening f = {.scene = scene};
    if (!scene->mRootNode || !scene->mNumMeshes) return refuse(out, "it holds no mesh");
    count_node(&f, scene->mRootNode);
    if (!f.triangles) return refuse(out, "it holds no triangle");
    if (!nd_mesh_new(&f.mesh, f.vertices, f.triangles, f.parts, false))
        return refuse(out, "it is too large for the memory");
    nd_mesh_head head = {ND_MESH_MAGIC, f.mesh.vertices, f.mesh.triangles, f.mesh.parts};
    size_t size = (size_t)((unsigned char *)(f.mesh.index + 3 * f.triangles) -
                           (unsigned char *)f.mesh.storage);
    f.vertices = f.triangles = f.parts = 0;
    fill_node(&f, scene->mRootNode, &identity);
    memcpy(f.mesh.storage, &head, sizeof head);
    bool sent = nd_child_write(out, f.mesh.storage, size);
    nd_mesh_free(&f.mesh);
    return sent ? 0 : 1;
}

typedef struct { const char *path; } import_job;

static int import(void *context, int out) {
    const import_job *job = context;
    const struct aiScene *scene = aiImportFile(job->path, aiProcess_Triangulate);
    if (!scene) return refuse(out, aiGetErrorString());
    int code = send_scene(scene, out);
    aiReleaseImport(scene);
    return code;
}

static bool explain(const nd_child *child, ndl_error *error) {
    switch (child->end) {
    case ND_CHILD_CRASHED:
        return nd_fail(error, NDL_E_FILE, 0, "crashed the importer; the file is malformed", NULL);
    case ND_CHILD_TOO_SLOW:
        return nd_fail(error, NDL_E_LIMIT, 0, "took the importer too long", NULL);
    case ND_CHILD_TOO_LONG: return nd_fail(error, NDL_E_LIMIT, 0, "is too large", NULL);
    case ND_CHILD_INTERRUPTED: return nd_fail(error, NDL_E_CANCELLED, 0, "interrupted", NULL);
    default: return nd_fail(error, NDL_E_MEMORY, 0, "no process or memory to import it", NULL);
    }
}

bool nd_mesh_import(const char *path, nd_limits limits, nd_mesh *m, ndl_error *error) {
    *m = (nd_mesh){0};
    if (!nd_file_readable(path, error)) return false;
    nd_child child = nd_child_run(import, &(import_job){path}, limits);
    if (child.end != ND_CHILD_DONE) return explain(&child, error);
    return nd_mesh_unpack(child.bytes, child.count, m, error);
}
