/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_CORE_EVAL_H
#define ND_CORE_EVAL_H
#include "core/kernels.h"
#include "core/material.h"

enum { ND_TILE = 256 }; /* directions evaluated at a time: scratch of a tile stays in L1 */

/* brdf, or brdf_cos, of one lobe without its weight, for at most ND_TILE pairs. */
void nd_lobe_values(const nd_kernel_table *k, const nd_lobe *l, bool cosine, const nd_batch *q);

#endif
