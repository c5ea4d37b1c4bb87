/* SPDX-License-Identifier: Apache-2.0 */
/* The registered models. One entry comes from two lines of models.def and the model's header. */
#ifndef ND_CORE_REGISTRY_H
#define ND_CORE_REGISTRY_H
#include "core/schema.h"

enum { ND_ANY_NDF = -1, ND_NO_FACET = -2 };

typedef struct {
    const char *name;
    const nd_schema *(*schema)(void);
    const ndl_manual *manual;
    size_t manual_count;
    const unsigned *traits; /* claims and ND_TRAIT_... of each kernel; NULL for a composed model */
    const int *kernels;     /* ND_KERNEL_... of each combination of its choices; likewise */
    int ndf;                /* of a composed model: its fixed ndf, or ND_ANY_NDF */
} nd_model;

size_t nd_model_count(void);
const nd_model *nd_model_at(size_t i);
/* NULL where there is none. */
const nd_model *nd_model_find(const char *name);

#endif
