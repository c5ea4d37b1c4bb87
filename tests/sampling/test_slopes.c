/* SPDX-License-Identifier: Apache-2.0 */
/* The inversion behind Beckmann's visible normals: the distribution function of the visible slopes,
   in double, at the slope that beckmann_visible_slope() gives for u is u, to 1e-6. */
#include "ndl_test.h"

#include "shade/prelude_c.h"

#include "shade/math.h"
#include "shade/visible_normals.h"

/* The share of visible slopes below x for a stretched viewer of cosine c and sine s. */
static double share_below(double x, double c, double s) {
    double last = fmin(c / fmax(s, 1e-30), 30.0), inv_sqrt_pi = 0.56418958354775628695;
    double whole = c * (1.0 + erf(last)) + inv_sqrt_pi * s * exp(-last * last);
    return (c * (1.0 + erf(x)) + inv_sqrt_pi * s * exp(-x * x)) / whole;
}

static float u_of(int k) {
    if (k < 60) return (float)(1e-3 * pow(0.75, k));
    if (k < 120) return fminf((float)(1.0 - 1e-3 * pow(0.75, k - 60)), 0x1.fffffep-1f);
    return ((float)k - 119.5f) / 1000.0f;
}

static void the_visible_slope_has_the_share_u_below_it(void **state) {
    double worst = 0.0;
    (void)state;
    for (int i = 0; i <= 600; i++) {
        double theta = 0.5 * 3.14159265358979 * i / 600.0;
        float c = i == 600 ? 0.0f : (float)cos(theta), s = (float)sin(theta);
        for (int k = 0; k < 1120; k++) {
            float u = u_of(k), x = beckmann_visible_slope(c, s, u);
            double gap = fabs(share_below((double)x, (double)c, (double)s) - (double)u);
            worst = fmax(worst, gap);
            if (gap <= 1e-6) continue;
            print_error("cosine %.9g, u %.9g: slope %.9g, off by %.3g\n", (double)c, (double)u,
                        (double)x, gap);
            fail();
        }
    }
    print_message("at most %.3g off\n", worst);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_visible_slope_has_the_share_u_below_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
