/* SPDX-License-Identifier: Apache-2.0 */
/* Law `reciprocity`: f_r(wi, wo) = f_r(wo, wi) for every material that claims it.

   The bound: the texts treat wi and wo alike, so most values are equal bit for bit; where the
   order of a product or of an interpolation differs, each side has some 30 roundings of 2^-24 at
   most, 2e-6 of the value, two sides 4e-6. Where the terms of a sum cancel, the contract's
   4 k 2^-23 per side comes on top. Subnormal values have fewer digits: 1e-37. */
#include "directions.h"

#ifndef LAW_PAIRS
#define LAW_PAIRS 500000 /* per model */
#endif
enum { VECTORS = 64, FEWEST = 2 * UNIT_KINDS };
static const double RELATIVE = 4e-6, ABSOLUTE = 1e-37;

static ndl_vec3 vector_at(const float w[3][BATCH], size_t i) {
    return (ndl_vec3){w[0][i], w[1][i], w[2][i]};
}

static double channel(ndl_rgb f, int c) {
    return (double)(c == 0 ? f.r : c == 1 ? f.g : f.b);
}

/* Condition number of a value with respect to the six components, by finite differences. */
static double condition(const ndl_material *m, const pairs *p, size_t i, int c) {
    const double step = 0x1p-12;
    double f = channel(ndl_brdf(m, vector_at(p->wi, i), vector_at(p->wo, i)), c), k = 0.0;
    for (int axis = 0; axis < 6; axis++) {
        ndl_vec3 w[2] = {vector_at(p->wi, i), vector_at(p->wo, i)};
        float *x = axis % 3 == 0 ? &w[axis / 3].x : axis % 3 == 1 ? &w[axis / 3].y : &w[axis / 3].z;
        *x *= (float)(1.0 + step);
        k += fabs(channel(ndl_brdf(m, w[0], w[1]), c) - f) / step;
    }
    return k / f;
}

static void try_material(const ndl_material *m, pairs *p, size_t n) {
    static pairs other;
    ndl_brdf_n(m, n, wi_of(p), wo_of(p), rgb_of(p));
    ndl_brdf_n(m, n, wo_of(p), wi_of(p), rgb_of(&other));
    for (size_t i = 0; i < n; i++) {
        for (int c = 0; c < 3; c++) {
            double f = (double)p->rgb[c][i], g = (double)other.rgb[c][i];
            if (is_close(f, g, RELATIVE, ABSOLUTE)) continue;
            if (!is_close(f, g, RELATIVE + 8.0 * 0x1p-23 * condition(m, p, i, c), ABSOLUTE))
                broken(m, "", p, i, "not what wi and wo exchanged give", f / g - 1.0);
        }
    }
}

static void exchanging_wi_and_wo_changes_nothing(void **state) {
    static pairs p;
    size_t model = model_of(state), tried = 0;
    int axes, all = combinations(model, &axes);
    unsigned corners = 1u << (axes < MOST_AXES ? axes : MOST_AXES);
    size_t n = LAW_PAIRS / ((size_t)all * (corners + VECTORS));
    n = n < FEWEST ? FEWEST : n > BATCH ? BATCH : n;
    draws d = draws_of(model + 100);
    for (int c = 0; c < all; c++) {
        for (unsigned i = 0; i < corners + VECTORS; i++) {
            ndl_material *m = i < corners ? corner_material(model, c, i)
                                          : vector_material(model, c, i - corners, false);
            if (ndl_material_claims(m) & NDL_CLAIM_RECIPROCITY) {
                fill_pairs(&d, &p, n, UNIT_KINDS);
                try_material(m, &p, n);
                tried++;
            }
            ndl_material_free(m);
        }
    }
    print_message("%zu materials claim it, %zu pairs each\n", tried, n);
}

int main(void) {
    return run_over_models("reciprocity", exchanging_wi_and_wo_changes_nothing);
}
