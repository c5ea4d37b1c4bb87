/* SPDX-License-Identifier: Apache-2.0 */
/* What a material is inside: for each lobe the words that were written, and the fields that the
   kernels read. */
#ifndef ND_CORE_MATERIAL_H
#define ND_CORE_MATERIAL_H
#include "core/registry.h"

/* Which functions a microfacet lobe is composed of: numbers of the words of its choices. */
typedef struct { int ndf, masking, fresnel; } nd_facet;

typedef struct {
    const nd_model *model;
    nd_call call;    /* as written, for printing and for changed copies */
    void *fields;    /* struct <model>_p of the shading text */
    float weight[3];
    float share[2];  /* in a sum, drawn with odds share[0] + share[1] (1 - wo.z)^5 (draw.c) */
    int kernel;      /* ND_KERNEL_..., for models that are not composed */
    nd_facet facet;  /* for those that are */
    unsigned traits; /* NDL_CLAIM_... and ND_TRAIT_... */
} nd_lobe;

struct ndl_material {
    nd_arena arena;
    nd_lobe *lobes;
    size_t count;
    char *text, *json;
};

/* A material of so many empty lobes; NULL with *error filled. */
ndl_material *nd_material_new(size_t lobes, ndl_error *error);

/* Gives every lobe's call its meaning and prints the whole; m, or NULL with m freed. */
ndl_material *nd_material_finish(ndl_material *m, ndl_error *error);

/* "1.color.g" -> lobe 1, key "color" (room bytes), channel 1; channel -1: all of them. */
bool nd_parameter_path(const char *path, size_t *lobe, char *key, size_t room, int *channel);

#endif
