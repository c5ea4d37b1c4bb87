/* SPDX-License-Identifier: Apache-2.0 */
/* Integrals that are known exactly: the distributions are normalised, their masking shows the
   projected area that it must, and albedos with a closed form. Quadrature here is the midpoint rule
   in double over the half vector, none of it the library's. */
#include "identities.h"

enum { RADII = 600, AZIMUTHS = 720 };
/* Float directions and values, 1e-6, and the rule: some 1e-5 where the area has a kink. */
static const double OF_RULE = 1e-4;

/* The integral of D(h) g(h) over the hemisphere of h, g = h.z where wo is NULL, else max(0, wo.h).
   tan theta_h = a(phi) u/(1 - u), where a(phi) is the width at that azimuth: u covers peak and tail
   evenly. sin theta d theta = t cos^3 dt. */
static double over_half_vectors(const ndl_material *m, double ax, double ay, const double *wo) {
    static float w[3][RADII], out[RADII];
    static double weight[RADII];
    ndl_vec3_n h = {w[0], w[1], w[2]};
    double sum = 0.0;
    for (int j = 0; j < AZIMUTHS; j++) {
        double phi = TURN * (j + 0.5) / AZIMUTHS, cx = cos(phi), cy = sin(phi);
        double a = 1.0 / sqrt(cx * cx / (ax * ax) + cy * cy / (ay * ay));
        for (int i = 0; i < RADII; i++) {
            double u = (i + 0.5) / RADII, t = a * u / (1.0 - u), z = 1.0 / sqrt(1.0 + t * t);
            double g = wo ? fmax(0.0, z * (t * (wo[0] * cx + wo[1] * cy) + wo[2])) : z;
            w[0][i] = (float)(t * z * cx);
            w[1][i] = (float)(t * z * cy);
            w[2][i] = (float)z;
            weight[i] = g * t * z * z * z * a / ((1.0 - u) * (1.0 - u));
        }
        ndl_term_n(m, NDL_TERM_D, RADII, h, h, (ndl_rgb_n){out, out, out}); /* wi = wo = h */
        for (int i = 0; i < RADII; i++) sum += weight[i] * (double)out[i];
    }
    return sum * TURN / AZIMUTHS / RADII;
}

static const double WIDTHS[][2] = {{0.01, 0.01}, {0.1, 0.1}, {0.5, 0.5}, {1.0, 1.0},
                                   {3.0, 3.0},   {0.1, 0.5}, {2.0, 0.7}};
enum { WIDTH_COUNT = sizeof WIDTHS / sizeof *WIDTHS };

static void distributions_are_normalised(void **state) {
    (void)state;
    static const char *const ndfs[] = {"ggx", "beckmann", "blinn"};
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < WIDTH_COUNT; i++) {
            double x = WIDTHS[i][0], y = WIDTHS[i][1];
            if (k == 2 && (x != y || x > 1.0)) continue;
            ndl_material *m = parsed("microfacet(ndf=%s,alpha_x=%g,alpha_y=%g)", ndfs[k], x, y);
            double area = over_half_vectors(m, x, y, NULL);
            print_message("%s %g %g: %.7f\n", ndfs[k], x, y, area);
            assert_absolute(area, 1.0, OF_RULE);
            ndl_material_free(m);
        }
    }
}

/* The visible microsurface projects to the surface: wo.z = G1(wo) int D(h) max(0, wo.h) dh. */
static void smith_masking_shows_the_projected_area(void **state) {
    (void)state;
    static const char *const ndfs[] = {"ggx", "beckmann"};
    static const double heights[] = {0.9, 0.4, 0.1};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < WIDTH_COUNT; i++) {
            ndl_material *m = parsed("%s(masking=smith,alpha_x=%g,alpha_y=%g)", ndfs[k],
                                     WIDTHS[i][0], WIDTHS[i][1]);
            for (int z = 0; z < 3; z++) {
                float w[3];
                direction_at(heights[z], 0.6, w);
                const double wo[3] = {(double)w[0], (double)w[1], (double)w[2]};
                double area = over_half_vectors(m, WIDTHS[i][0], WIDTHS[i][1], wo);
                /* With the light at the normal, where nothing is hidden, G is G1(wo). */
                const ndl_vec3 n = {0, 0, 1}, view = {w[0], w[1], w[2]};
                ndl_rgb g = ndl_term(m, NDL_TERM_G, n, view);
                assert_relative((double)g.r * area, wo[2], 3.0 * OF_RULE);
            }
            ndl_material_free(m);
        }
    }
}

static void albedos_with_a_closed_form(void **state) {
    (void)state;
    static const double cosines[] = {1.0, 0.8, 0.5, 0.1, 0.03, 0.01};
    ndl_material *correlated = parsed("ggx(alpha=1,fresnel=none,f0=1)");
    ndl_material *kelemen = parsed("ggx(alpha=1,masking=kelemen,fresnel=none,f0=1)");
    ndl_material *none = parsed("ggx(alpha=1,masking=none,fresnel=none,f0=1)");
    ndl_material *lambert = parsed("lambert(color=0.25)");
    for (int i = 0; i < 6; i++) {
        float w[3], error;
        direction_at(cosines[i], 1.0, w);
        ndl_vec3 wo = {w[0], w[1], w[2]};
        double c = (double)w[2], want = 1.0 - c * log1p(1.0 / c);
        assert_absolute(ndl_albedo(correlated, wo, 1e-6f, &error).r, want, 3e-6);
        assert_absolute(ndl_albedo(kelemen, wo, 1e-6f, &error).g, want, 3e-6);
        assert_relative(ndl_albedo(none, wo, 1e-6f, &error).b, 0.5 / c, 3e-6);
        assert_relative(ndl_albedo(lambert, wo, 1e-6f, &error).b, 0.25, 3e-6);
    }
    ndl_material_free(correlated);
    ndl_material_free(kelemen);
    ndl_material_free(none);
    ndl_material_free(lambert);
}

/* At normal incidence (g + 2)/(2 pi) of Phong reflects 1, the exact factor of Blinn's too, and the
   lecture's Phong, which takes the place of f cos, 2 pi/(g + 1): formulas S4.22, S4.25. */
static void powers_of_a_cosine_reflect_what_their_factors_say(void **state) {
    (void)state;
    static const double exponents[] = {0.0, 1.0, 5.0, 10.0, 100.0};
    const ndl_vec3 n = {0, 0, 1};
    float error;
    for (int i = 0; i < 5; i++) {
        double g = exponents[i];
        ndl_material *m = parsed("phong(variant=normalized,exponent=%g)", g);
        assert_relative(ndl_albedo(m, n, 1e-6f, &error).r, 1.0, 5e-6);
        ndl_material_free(m);
        m = parsed("blinn_phong(variant=normalized_exact,exponent=%g)", g);
        assert_relative(ndl_albedo(m, n, 1e-6f, &error).r, 1.0, 5e-6);
        ndl_material_free(m);
        m = parsed("phong(exponent=%g)", g);
        assert_relative(ndl_albedo(m, n, 1e-6f, &error).r, TURN / (g + 1.0), 5e-6);
        ndl_material_free(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distributions_are_normalised),
        cmocka_unit_test(smith_masking_shows_the_projected_area),
        cmocka_unit_test(albedos_with_a_closed_form),
        cmocka_unit_test(powers_of_a_cosine_reflect_what_their_factors_say),
    };
    return cmocka_run_group_tests_name("normalization", tests, NULL, NULL);
}
