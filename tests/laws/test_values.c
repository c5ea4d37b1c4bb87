/* SPDX-License-Identifier: Apache-2.0 */
/* Laws `finite`, `non_negative` and `lit_gate` over every registered model: whatever the
   parameters and the directions, broken inputs included, a value is a finite number >= 0, and +0
   unless both directions are above the horizon. The terms as well, G and F also at most 1. */
#include "directions.h"

#ifndef LAW_PAIRS
#define LAW_PAIRS 1000000 /* per model and quantity */
#endif
enum { VECTORS = 64, FEWEST = 3 * ALL_KINDS };

static void judge(const ndl_material *m, const char *option, const pairs *p, size_t n, float most) {
    for (size_t i = 0; i < n; i++) {
        bool on = p->wi[2][i] > 0.0f && p->wo[2][i] > 0.0f;
        for (int c = 0; c < 3; c++) {
            float x = p->rgb[c][i];
            if (!isfinite(x)) broken(m, option, p, i, "not finite", (double)x);
            if (x < 0.0f) broken(m, option, p, i, "negative", (double)x);
            if (!on && (x != 0.0f || signbit(x)))
                broken(m, option, p, i, "not +0 below the horizon", (double)x);
            if (x > most) broken(m, option, p, i, "above its bound", (double)x);
        }
    }
}

static void try_material(ndl_material *m, pairs *p, size_t n) {
    static const struct { ndl_term_kind term; const char *option; float most; } terms[] = {
        {NDL_TERM_D, " --term D", FLT_MAX}, {NDL_TERM_G, " --term G", 1.0f},
        {NDL_TERM_V, " --term V", FLT_MAX}, {NDL_TERM_F, " --term F", 1.0f}};
    ndl_brdf_n(m, n, wi_of(p), wo_of(p), rgb_of(p));
    judge(m, "", p, n, FLT_MAX);
    ndl_brdf_cos_n(m, n, wi_of(p), wo_of(p), rgb_of(p));
    judge(m, " --cos", p, n, FLT_MAX);
    ndl_scanline_n(m, n, wi_of(p), wo_of(p), rgb_of(p));
    judge(m, " --convention scanline", p, n, FLT_MAX);
    for (int t = 0; t < 4; t++) {
        ndl_term_n(m, terms[t].term, n, wi_of(p), wo_of(p), rgb_of(p));
        if (ndl_has_term(m, terms[t].term)) judge(m, terms[t].option, p, n, terms[t].most);
        else judge(m, terms[t].option, p, n, 0.0f);
    }
    ndl_material_free(m);
}

static void values_are_finite_non_negative_and_gated(void **state) {
    static pairs p;
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes);
    unsigned corners = 1u << (axes < MOST_AXES ? axes : MOST_AXES);
    size_t materials = (size_t)all * (corners + VECTORS);
    size_t n = LAW_PAIRS / materials;
    n = n < FEWEST ? FEWEST : n > BATCH ? BATCH : n;
    draws d = draws_of(model);
    for (int c = 0; c < all; c++) {
        for (unsigned i = 0; i < corners + VECTORS; i++) {
            fill_pairs(&d, &p, n, ALL_KINDS);
            try_material(i < corners ? corner_material(model, c, i)
                                     : vector_material(model, c, i - corners, false),
                         &p, n);
        }
    }
    print_message("%zu materials, %zu pairs each\n", materials, n);
}

int main(void) {
    return run_over_models("finite, non-negative, gated",
                           values_are_finite_non_negative_and_gated);
}
