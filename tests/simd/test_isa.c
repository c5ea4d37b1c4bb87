/* SPDX-License-Identifier: Apache-2.0 */
/* Every instruction set of this machine against scalar, bit for bit: random, edge and denormal
   inputs, all tails, misaligned arrays, results in place, and nothing written past the end; for
   every model and combination of its choices, with uniform parameters and per lane. */
#include "../laws/materials.h"

enum { MOST = 1024, PAD = 16, ARRAYS = 9 };
static const char *const ISAS[] = {"x86-64", "x86-64-v3", "x86-64-v4", "neon", "wasm"};
enum { ISA_COUNT = sizeof ISAS / sizeof *ISAS };

typedef enum { BRDF, BRDF_COS, SCANLINE, LANES, LANES_COS, OPS } operation;
static const char *const OP_NAMES[OPS] = {"brdf", "brdf_cos", "scanline", "brdf_lanes",
                                          "brdf_cos_lanes"};

static float input[6][MOST], lane_values[MOST], want[3][MOST];
static float memory[ARRAYS][MOST + 2 * PAD];

/* No infinities and nothing whose square is one: their differences are NaN, whose sign and payload
   follow the order of a sum's operands, which compilers choose. Such pairs have some finite value
   (tests/laws), not everywhere the same. */
static const float EDGES[] = {0.0f,      -0.0f,     1.0f,   -1.0f, 0x1p-149f,      -0x1p-149f,
                              0x1p-126f, 0x1p-127f, 1e-20f, 1e-9f, 0x1.fffffep-1f, 0x1.000002p0f,
                              0x1p-24f,  0.5f,      1e4f,   -7e3f, -0.70710677f};
enum { EDGE_COUNT = sizeof EDGES / sizeof *EDGES };

static void unit(draws *d, float w[3]) {
    double x, y, z, l;
    do {
        x = 2.0 * draw(d) - 1.0;
        y = 2.0 * draw(d) - 1.0;
        z = 1.1 * draw(d) - 0.1;
        l = x * x + y * y + z * z;
    } while (l > 1.0 || l < 0.01);
    double grazing = draw_bits(d) >> 61 ? 1.0 : pow(10.0, -9.0 * draw(d));
    l = sqrt(x * x + y * y + z * z * grazing * grazing);
    w[0] = (float)(x / l);
    w[1] = (float)(y / l);
    w[2] = (float)(z * grazing / l);
}

/* Half of the pairs are unit vectors, an eighth of them equal or opposed; the others take single
   components, or all of them, from EDGES. */
static void fill_input(draws *d) {
    for (size_t i = 0; i < MOST; i++) {
        float w[6];
        unsigned kind = (unsigned)(draw_bits(d) >> 60);
        unit(d, w);
        unit(d, w + 3);
        if (kind == 0) memcpy(w + 3, w, 3 * sizeof *w);
        if (kind == 1)
            for (int k = 0; k < 2; k++)
                w[3 + k] = -w[k];
        for (int k = 0; k < 6; k++) {
            bool edge = kind >= 12 || (kind >= 8 && draw_bits(d) >> 62 == 0);
            input[k][i] = edge ? EDGES[draw_bits(d) % EDGE_COUNT] : w[k];
        }
    }
}

/* A call with copies of n inputs `shift` floats after an aligned place; results in place of the
   inputs, or in arrays of their own. */
typedef struct {
    const ndl_material *m;
    operation op;
    const ndl_lanes *lane;
    size_t n, shift;
    bool in_place;
} call;

static float *array_of(const call *c, int i) {
    return memory[i] + PAD + c->shift % PAD;
}

static float *result_of(const call *c, int channel) {
    return array_of(c, c->in_place ? channel : 6 + channel);
}

static void evaluate(const call *c) {
    for (int i = 0; i < ARRAYS; i++)
        for (size_t k = 0; k < MOST + 2 * PAD; k++)
            memory[i][k] = -77.0f;
    for (int i = 0; i < 6; i++)
        memcpy(array_of(c, i), input[i], c->n * sizeof(float));
    ndl_vec3_n wi = {array_of(c, 0), array_of(c, 1), array_of(c, 2)};
    ndl_vec3_n wo = {array_of(c, 3), array_of(c, 4), array_of(c, 5)};
    ndl_rgb_n rgb = {result_of(c, 0), result_of(c, 1), result_of(c, 2)};
    switch (c->op) {
    case BRDF:
        ndl_brdf_n(c->m, c->n, wi, wo, rgb);
        break;
    case BRDF_COS:
        ndl_brdf_cos_n(c->m, c->n, wi, wo, rgb);
        break;
    case SCANLINE:
        ndl_scanline_n(c->m, c->n, wi, wo, rgb);
        break;
    case LANES:
        ndl_brdf_lanes_n(c->m, 1, c->lane, c->n, wi, wo, rgb);
        break;
    default:
        ndl_brdf_cos_lanes_n(c->m, 1, c->lane, c->n, wi, wo, rgb);
        break;
    }
}

static void differs(const call *c, const char *isa, int channel, size_t i) {
    fail_msg("%s of %s, %s: pair %zu of %zu, channel %d is %a, scalar %a\n"
             "wi %a %a %a, wo %a %a %a, %s = %a, shift %zu%s",
             OP_NAMES[c->op], ndl_material_text(c->m), isa, i, c->n, channel,
             (double)result_of(c, channel)[i], (double)want[channel][i], (double)input[0][i],
             (double)input[1][i], (double)input[2][i], (double)input[3][i], (double)input[4][i],
             (double)input[5][i], c->lane ? c->lane->key : "no lane",
             c->lane ? (double)lane_values[i] : 0.0, c->shift, c->in_place ? ", in place" : "");
}

static bool is_same(float a, float b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

static void compare(const call *c, const char *isa) {
    for (int channel = 0; channel < 3; channel++) {
        const float *got = result_of(c, channel);
        for (size_t i = 0; i < c->n; i++)
            if (!is_same(got[i], want[channel][i])) differs(c, isa, channel, i);
        if (got[-1] != -77.0f || got[c->n] != -77.0f)
            fail_msg("%s of %s, %s: writes outside its %zu results", OP_NAMES[c->op],
                     ndl_material_text(c->m), isa, c->n);
    }
}

static void every_isa(call c) {
    ndl_use_isa("scalar");
    evaluate(&c);
    for (int k = 0; k < 3; k++)
        memcpy(want[k], result_of(&c, k), c.n * sizeof(float));
    for (int i = 0; i < ISA_COUNT; i++) {
        if (ndl_use_isa(ISAS[i]) != NDL_OK) continue;
        evaluate(&c);
        compare(&c, ISAS[i]);
    }
}

/* The first number of the model that may differ from lane to lane; fills in values around it. */
static bool choose_lane(const ndl_material *m, ndl_lanes *lane, draws *d) {
    size_t count;
    int model = ndl_model_find(ndl_material_model(m, 0));
    const ndl_param *p = ndl_model_params((size_t)model, &count);
    for (size_t k = 0, from = draw_bits(d) % count; k < count; k++) {
        const ndl_param *q = &p[(from + k) % count];
        if (q->kind != NDL_KIND_NUMBER && q->kind != NDL_KIND_COLOR) continue;
        *lane = (ndl_lanes){q->key, lane_values};
        if (ndl_lanes_check(m, 1, lane, NULL) != NDL_OK) continue;
        for (int i = 0; i < MOST; i++)
            lane_values[i] = draw_bits(d) >> 60
                                 ? (float)(q->low + draw(d) * fmin(q->high - q->low, 4.0))
                                 : EDGES[draw_bits(d) % EDGE_COUNT];
        return true;
    }
    return false;
}

static void all_operations(const ndl_material *m, size_t n, size_t shift, draws *d) {
    ndl_lanes lane;
    bool has_lane = choose_lane(m, &lane, d);
    for (int op = 0; op < OPS; op++) {
        bool lanes = op >= LANES;
        if (lanes && !has_lane) continue;
        every_isa((call){m, (operation)op, lanes ? &lane : NULL, n, shift, shift % 2 == 1});
    }
}

static void every_isa_has_the_bits_of_scalar(void **state) {
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes);
    int rounds = all < 16 ? 24 : 2;
    draws d = draws_of(model + 100);
    for (int c = 0; c < all; c++)
        for (int i = 0; i < rounds; i++) {
            fill_input(&d);
            ndl_material *m = vector_material(model, c, (unsigned)i, false);
            all_operations(m, MOST - (size_t)(draw_bits(&d) % 40), (size_t)i, &d);
            ndl_material_free(m);
        }
}

static void every_length_and_alignment_is_right(void **state) {
    size_t model = model_of(state);
    draws d = draws_of(model + 200);
    ndl_material *m = vector_material(model, 0, 1, false);
    fill_input(&d);
    for (size_t n = 0; n < 70; n++)
        all_operations(m, n, n, &d);
    for (size_t n = 250; n < 262; n++)
        all_operations(m, n, n, &d);
    ndl_material_free(m);
}

static void sums_of_lobes_too(void **state) {
    (void)state;
    draws d = draws_of(300);
    ndl_material *m = ndl_material_parse(
        "0.3*lambert(color=[0.9,0.5,0.1]) + 0.7*ggx(alpha_x=0.05, alpha_y=0.4, preset=gold) + "
        "[0.1,2,0.3]*blinn_phong(exponent=80)",
        NULL);
    assert_non_null(m);
    fill_input(&d);
    for (size_t n = 0; n < 40; n++)
        all_operations(m, n, n, &d);
    all_operations(m, MOST, 3, &d);
    ndl_material_free(m);
}

int main(void) {
    for (int i = 0; i < ISA_COUNT; i++)
        if (ndl_use_isa(ISAS[i]) == NDL_OK) print_message("compared with scalar: %s\n", ISAS[i]);
    const struct CMUnitTest sums[] = {cmocka_unit_test(sums_of_lobes_too)};
    return run_over_models("bits", every_isa_has_the_bits_of_scalar) +
           run_over_models("lengths", every_length_and_alignment_is_right) +
           cmocka_run_group_tests(sums, NULL, NULL);
}
