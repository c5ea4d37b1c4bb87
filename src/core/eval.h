/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_CORE_EVAL_H
#define ND_CORE_EVAL_H
#include "core/kernels.h"
#include "core/material.h"

/* brdf, or brdf_cos, of one lobe without its weight, for at most ND_TILE pairs, any
   number where the lobe runs as one loop. */
void nd_lobe_values(const nd_kernel_table *k, const nd_lobe *l, bool cosine, const nd_batch *q);

/* How wide a lobe's highlight is, as slopes of the half vector along t and b; 1 where it has none.
   For quadrature and sampling strategies, not a formula. */
void nd_lobe_widths(const nd_lobe *l, double width[2]);

#endif
