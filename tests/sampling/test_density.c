/* SPDX-License-Identifier: Apache-2.0 */
/* The density against what is drawn: over the hemisphere it adds up to the share of draws that give
   a sample, cell by cell it predicts where they fall, and the mean weight is the albedo. */
#include "sampling.h"

/* The hemisphere in cells of equal angles: a fine grid for integrals, blocks of it for counts. */
enum { FINE = 960, BLOCK = 48, CELLS = FINE / BLOCK, BATCHES = 48 };
static const double PI_ = 3.14159265358979323846;
static const float COSINES[] = {0.95f, 0.5f, 0.08f};
enum { VIEWERS = sizeof COSINES / sizeof *COSINES };
/* One-sided normal deviate: a false alarm once in 3e8, over all the tests once in 1e6. */
static const double MOST_DEVIATE = 5.6;

typedef struct {
    double expected[CELLS * CELLS], sum; /* the share of each cell, by quadrature */
    double counted[CELLS * CELLS], lost; /* the share drawn */
    double drawn;
} histogram;

/* One row of the fine grid: theta fixed. */
static void integrate_row(const ndl_material *m, ndl_vec3 wo, int row, histogram *h) {
    static float x[FINE], y[FINE], z[FINE], ox[FINE], oy[FINE], oz[FINE], pdf[FINE];
    static double cosine[FINE], sine[FINE]; /* of the columns' azimuths */
    double step = 0.5 * PI_ / FINE, theta = (row + 0.5) * step, s = sin(theta);
    double area = 2.0 * PI_ / FINE * (cos(row * step) - cos((row + 1) * step));
    for (int i = 0; i < FINE && row == 0; i++) {
        cosine[i] = cos(2.0 * PI_ * (i + 0.5) / FINE);
        sine[i] = sin(2.0 * PI_ * (i + 0.5) / FINE);
    }
    for (int i = 0; i < FINE; i++) {
        x[i] = (float)(s * cosine[i]);
        y[i] = (float)(s * sine[i]);
        z[i] = (float)cos(theta);
        ox[i] = wo.x;
        oy[i] = wo.y;
        oz[i] = wo.z;
    }
    ndl_pdf_n(m, FINE, (ndl_vec3_n){x, y, z}, (ndl_vec3_n){ox, oy, oz}, pdf);
    for (int i = 0; i < FINE; i++) {
        h->expected[row / BLOCK * CELLS + i / BLOCK] += area * (double)pdf[i];
        h->sum += area * (double)pdf[i];
    }
}

static void count(const draws *d, histogram *h) {
    for (size_t i = 0; i < DRAWS; i++) {
        h->drawn += 1.0;
        if (!(d->pdf[i] > 0.0f)) {
            h->lost += 1.0;
            continue;
        }
        double z = fmin((double)d->wi[2][i], 1.0),
               turn = atan2((double)d->wi[1][i], (double)d->wi[0][i]);
        int row = (int)(acos(z) / (0.5 * PI_) * CELLS),
            column = (int)floor(turn / (2.0 * PI_) * CELLS);
        row = row < CELLS ? row : CELLS - 1;
        h->counted[row * CELLS + (column + CELLS) % CELLS] += 1.0;
    }
}

/* Pearson's statistic over cells of at least 10 expected draws, the others together, and those
   without a sample; as a normal deviate by Wilson and Hilferty. */
static double deviate(const histogram *h) {
    double chi2 = 0.0, rare = 0.0, rare_count = 0.0, lost = fmax(1.0 - h->sum, 0.0) * h->drawn;
    int cells = 0;
    for (int i = 0; i < CELLS * CELLS; i++) {
        double e = h->expected[i] * h->drawn, c = h->counted[i];
        if (e < 10.0) {
            rare += e;
            rare_count += c;
            continue;
        }
        chi2 += (c - e) * (c - e) / e;
        cells++;
    }
    rare += lost < 10.0 ? lost : 0.0;
    rare_count += lost < 10.0 ? h->lost : 0.0;
    if (lost >= 10.0) {
        chi2 += (h->lost - lost) * (h->lost - lost) / lost;
        cells++;
    }
    chi2 += (rare_count - rare) * (rare_count - rare) / fmax(rare, 10.0);
    double k = cells > 1 ? cells : 1, spread = 2.0 / (9.0 * k);
    return (cbrt(chi2 / k) - (1.0 - spread)) / sqrt(spread);
}

/* The density of `judged` against draws of `drawn`. */
static histogram compare(const ndl_material *judged, const ndl_material *drawn, ndl_vec3 wo,
                         uint64_t seed) {
    static draws d;
    histogram h;
    memset(&h, 0, sizeof h);
    for (int row = 0; row < FINE; row++)
        integrate_row(judged, wo, row, &h);
    for (int k = 0; k < BATCHES; k++) {
        fill_draws(&d, wo, &seed);
        draw_batch(drawn, DRAWS, &d);
        count(&d, &h);
    }
    return h;
}

static void draws_fall_where_the_density_says(void **state) {
    (void)state;
    double worst = 0.0, worst_sum = 0.0;
    for (size_t i = 0; i < wide_count(); i++)
        for (int k = 0; k < VIEWERS; k++) {
            ndl_material *m = material(wide_text(i));
            histogram h = compare(m, m, viewer((double)COSINES[k], 0.13), 1 + 7 * i);
            double z = deviate(&h), gap = h.sum + h.lost / h.drawn - 1.0;
            double noise = 1e-4 + 5.0 * sqrt(h.lost) / h.drawn;
            worst = fmax(worst, z);
            worst_sum = fmax(worst_sum, fabs(gap) / noise);
            if (z > MOST_DEVIATE || fabs(gap) > noise) {
                print_error(
                    "%s at wo.z = %g: deviate %.2f, density and lost draws add up to 1 %+g\n",
                    wide_text(i), (double)COSINES[k], z, gap);
                fail();
            }
            ndl_material_free(m);
        }
    print_message("largest deviate %.2f of %.1f, sum off by %.2f of the noise\n", worst,
                  MOST_DEVIATE, worst_sum);
}

static void a_wrong_density_is_seen(void **state) {
    static const char *const pairs[][2] = {
        {"ggx(alpha=0.3)", "ggx(alpha=0.309)"},
        {"beckmann(alpha=0.3)", "beckmann(alpha=0.309)"},
        {"ggx(alpha_x=0.2, alpha_y=0.4)", "ggx(alpha_x=0.4, alpha_y=0.2)"},
        {"phong(exponent=20)", "phong(exponent=21)"},
        {"ward(alpha=0.3)", "beckmann(alpha=0.3)"},
        {"lambert", "phong(exponent=0)"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        ndl_material *judged = material(pairs[i][0]), *drawn = material(pairs[i][1]);
        histogram h = compare(judged, drawn, viewer(0.5, 0.13), 99);
        if (deviate(&h) <= MOST_DEVIATE) {
            print_error("draws of %s pass for %s\n", pairs[i][1], pairs[i][0]);
            fail();
        }
        ndl_material_free(judged);
        ndl_material_free(drawn);
    }
}

typedef struct {
    double mean[3], sigma[3];
} moments;

static moments mean_weight(const ndl_material *m, ndl_vec3 wo, uint64_t seed) {
    static draws d;
    double sum[3] = {0}, squares[3] = {0}, n = (double)BATCHES * DRAWS;
    moments result;
    for (int k = 0; k < BATCHES; k++) {
        fill_draws(&d, wo, &seed);
        draw_batch(m, DRAWS, &d);
        for (int c = 0; c < 3; c++)
            for (size_t i = 0; i < DRAWS; i++) {
                sum[c] += (double)d.rgb[c][i];
                squares[c] += (double)d.rgb[c][i] * (double)d.rgb[c][i];
            }
    }
    for (int c = 0; c < 3; c++) {
        result.mean[c] = sum[c] / n;
        result.sigma[c] = sqrt(fmax(squares[c] / n - result.mean[c] * result.mean[c], 0.0) / n);
    }
    return result;
}

static void check_mean(const char *text, float cosine, double *worst) {
    ndl_material *m = material(text);
    ndl_vec3 wo = viewer((double)cosine, 0.13);
    float error;
    ndl_rgb e = ndl_albedo(m, wo, 1e-5f, &error);
    moments got = mean_weight(m, wo, 5);
    const float albedo[3] = {e.r, e.g, e.b};
    for (int c = 0; c < 3; c++) {
        double gap = fabs(got.mean[c] - (double)albedo[c]);
        double room = 4.0 * got.sigma[c] + (double)error + 2e-6 * (double)albedo[c];
        *worst = fmax(*worst, gap / fmax(room, 1e-30));
        if (gap <= room) continue;
        print_error("%s at wo.z = %g, channel %d: mean weight %.8g, sigma %.2g, albedo %.8g\n",
                    text, (double)cosine, c, got.mean[c], got.sigma[c], (double)albedo[c]);
        fail();
    }
    ndl_material_free(m);
}

static void the_mean_weight_is_the_albedo(void **state) {
    double worst = 0.0;
    (void)state;
    for (int k = 0; k < VIEWERS; k++) {
        for (size_t i = 0; i < wide_count(); i++)
            check_mean(wide_text(i), COSINES[k], &worst);
        check_mean("ggx(alpha=0.01, preset=gold)", COSINES[k], &worst);
        check_mean("beckmann(alpha=0.01, preset=gold)", COSINES[k], &worst);
        check_mean("microfacet(ndf=blinn, alpha=0.02, f0=1)", COSINES[k], &worst);
    }
    print_message("farthest mean at %.2f of 4 sigma\n", worst);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_fall_where_the_density_says),
        cmocka_unit_test(a_wrong_density_is_seen),
        cmocka_unit_test(the_mean_weight_is_the_albedo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
