/* SPDX-License-Identifier: Apache-2.0 */
/* Law `energy`: no more light leaves than arrives. The directional albedo of every material that
   claims it is at most 1 plus the error that the quadrature states plus 4e-6 of float values, with
   the colours and reflectances at their upper ends, straight on and down to the horizon. */
#include "directions.h"

#ifndef LAW_VECTORS
#define LAW_VECTORS 3
#endif
static const float NOV[] = {1.0f, 0.6f, 0.2f, 0.01f, 0.002f};
enum { ANGLES = sizeof NOV / sizeof *NOV };
static const double OF_FLOATS = 4e-6;
static const float TOLERANCE = 3e-4f;

static double brightest(const ndl_material *m, ndl_vec3 wo, float *error) {
    ndl_rgb e = ndl_albedo(m, wo, TOLERANCE, error);
    return fmax((double)e.r, fmax((double)e.g, (double)e.b));
}

static void try_material(const ndl_material *m, double phi, double *worst) {
    for (int i = 0; i < ANGLES; i++) {
        float w[3], error;
        direction_at((double)NOV[i], phi + i, w);
        ndl_vec3 wo = {w[0], w[1], w[2]};
        double e = brightest(m, wo, &error);
        *worst = fmax(*worst, e);
        if (e <= 1.0 + (double)error + OF_FLOATS) continue;
        print_error("albedo %.9g, stated error %.3g, at wo = %.9g %.9g %.9g\n"
                    "  reproduce: ndotl check '%s' --law energy\n"
                    "  the material: ndotl eval '%s' --print\n",
                    e, (double)error, (double)wo.x, (double)wo.y, (double)wo.z,
                    ndl_material_text(m), ndl_material_text(m));
        fail();
    }
}

static void no_more_light_leaves_than_arrives(void **state) {
    size_t model = model_of(state), tried = 0;
    int axes, all = combinations(model, &axes);
    double worst = 0.0;
    for (int c = 0; c < all; c++) {
        for (unsigned i = 0; i < thinned(LAW_VECTORS); i++) {
            ndl_material *m = vector_material(model, c, i, true);
            if (ndl_material_claims(m) & NDL_CLAIM_ENERGY) {
                try_material(m, 0.7 * i, &worst);
                tried++;
            }
            ndl_material_free(m);
        }
    }
    print_message("%zu materials claim it, largest albedo %.6f\n", tried, worst);
}

int main(void) {
    return run_over_models("energy", no_more_light_leaves_than_arrives);
}
