/* SPDX-License-Identifier: Apache-2.0 */
/* How a batch is asked for does not change a bit: one by one or all at once, any length, any
   alignment, outputs over the inputs, any instruction set, many parameters. Directions are finite:
   which operand's bits a NaN keeps is the compiler's choice. */
#include "directions.h"

#ifndef LAW_PAIRS
#define LAW_PAIRS 200000 /* per kernel */
#endif
enum { LONGEST_TAIL = 70 };
static const char *const ISAS[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon"};
enum { ISA_COUNT = sizeof ISAS / sizeof *ISAS };

typedef void batch_call(const ndl_material *, size_t, ndl_vec3_n, ndl_vec3_n, ndl_rgb_n);
static const struct { batch_call *call; const char *option; } CALLS[] = {
    {ndl_brdf_n, ""}, {ndl_brdf_cos_n, " --cos"}, {ndl_scanline_n, " --convention scanline"}};
enum { CALL_COUNT = sizeof CALLS / sizeof *CALLS };

static uint64_t hash_of(const pairs *p, size_t n, uint64_t hash) {
    for (int c = 0; c < 3; c++) {
        for (size_t i = 0; i < n; i++) {
            uint32_t bits;
            memcpy(&bits, &p->rgb[c][i], sizeof bits);
            hash = (hash ^ bits) * 0x100000001B3ULL;
        }
    }
    return hash;
}

/* Hash of the values and of the terms. */
static uint64_t hash_on(const char *isa, const ndl_material *m, pairs *p) {
    uint64_t hash = 0xCBF29CE484222325ULL;
    assert_int_equal(ndl_use_isa(isa), NDL_OK);
    for (int k = 0; k < CALL_COUNT; k++) {
        CALLS[k].call(m, BATCH, wi_of(p), wo_of(p), rgb_of(p));
        hash = hash_of(p, BATCH, hash);
    }
    for (int t = NDL_TERM_D; t <= NDL_TERM_F && ndl_has_term(m, (ndl_term_kind)t); t++) {
        ndl_term_n(m, (ndl_term_kind)t, BATCH, wi_of(p), wo_of(p), rgb_of(p));
        hash = hash_of(p, BATCH, hash);
    }
    return hash;
}

/* LAW_PAIRS for each kernel: a masking kernel of the composed models is used by 10
   combinations of the choices at least. */
static void every_instruction_set_gives_the_same_bits(void **state) {
    static pairs p;
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes);
    unsigned vectors = thinned(LAW_PAIRS / BATCH / (all > 50 ? 10 : 1));
    draws d = draws_of(model + 300);
    for (int c = 0; c < all; c++) {
        for (unsigned v = 0; v <= vectors; v++) {
            ndl_material *m = vector_material(model, c, v, false);
            fill_pairs(&d, &p, BATCH, v % 4 ? UNIT_KINDS : FINITE_KINDS);
            uint64_t want = hash_on("scalar", m, &p);
            for (int i = 1; i < ISA_COUNT; i++) {
                if (ndl_use_isa(ISAS[i]) != NDL_OK || hash_on(ISAS[i], m, &p) == want) continue;
                print_error("%s: %s has other bits than scalar\n", ndl_material_text(m), ISAS[i]);
                fail();
            }
            ndl_material_free(m);
        }
    }
    ndl_use_isa(NULL);
}

static void expect_same(const ndl_material *m, const char *option, const pairs *p, size_t at,
                        size_t n, const float *r, const float *g, const float *b) {
    for (size_t i = 0; i < n; i++) {
        const float got[3] = {r[i], g[i], b[i]};
        const float want[3] = {p->rgb[0][at + i], p->rgb[1][at + i], p->rgb[2][at + i]};
        if (memcmp(got, want, sizeof got) != 0)
            broken(m, option, p, at + i, "other bits in another batch", (double)got[0]);
    }
}

/* Any part of the batch, from any place, also into its own copied inputs. */
static void try_parts(const ndl_material *m, int k, const pairs *p) {
    static float x[6][BATCH], out[3][LONGEST_TAIL + 2];
    for (size_t n = 0; n <= LONGEST_TAIL; n++) {
        size_t at = n * 37 % 501; /* so that addresses are odd multiples of four bytes as well */
        out[0][n] = out[1][n] = out[2][n] = -7.0f;
        CALLS[k].call(m, n, (ndl_vec3_n){p->wi[0] + at, p->wi[1] + at, p->wi[2] + at},
                      (ndl_vec3_n){p->wo[0] + at, p->wo[1] + at, p->wo[2] + at},
                      (ndl_rgb_n){out[0], out[1], out[2]});
        expect_same(m, CALLS[k].option, p, at, n, out[0], out[1], out[2]);
        assert_true(out[0][n] == -7.0f && out[1][n] == -7.0f && out[2][n] == -7.0f);
    }
    for (int turn = 0; turn < 2; turn++) { /* over wi, then over wo, channels exchanged */
        memcpy(x, p->wi, sizeof p->wi);
        memcpy(x[3], p->wo, sizeof p->wo);
        float *r = x[3 * turn + 1], *g = x[3 * turn + 2], *b = x[3 * turn];
        CALLS[k].call(m, BATCH, (ndl_vec3_n){x[0], x[1], x[2]}, (ndl_vec3_n){x[3], x[4], x[5]},
                      (ndl_rgb_n){r, g, b});
        expect_same(m, CALLS[k].option, p, 0, BATCH, r, g, b);
    }
}

static void one_value_is_its_batch(const ndl_material *m, const pairs *p, int k, size_t i) {
    ndl_vec3 wi = {p->wi[0][i], p->wi[1][i], p->wi[2][i]};
    ndl_vec3 wo = {p->wo[0][i], p->wo[1][i], p->wo[2][i]};
    ndl_rgb f = k == 0   ? ndl_brdf(m, wi, wo)
                : k == 1 ? ndl_brdf_cos(m, wi, wo)
                         : ndl_scanline(m, wi, wo);
    expect_same(m, CALLS[k].option, p, i, 1, &f.r, &f.g, &f.b);
}

static void try_material(const ndl_material *m, pairs *p) {
    for (int i = 0; i < ISA_COUNT; i++) {
        if (ndl_use_isa(ISAS[i]) != NDL_OK) continue;
        for (int k = 0; k < CALL_COUNT; k++) {
            CALLS[k].call(m, BATCH, wi_of(p), wo_of(p), rgb_of(p));
            try_parts(m, k, p);
            for (size_t at = 0; at < BATCH; at += 61) one_value_is_its_batch(m, p, k, at);
        }
    }
    ndl_use_isa(NULL);
}

static void how_a_batch_is_cut_does_not_matter(void **state) {
    static pairs p;
    size_t model = model_of(state);
    int axes, all = combinations(model, &axes);
    draws d = draws_of(model + 400);
    fill_pairs(&d, &p, BATCH, FINITE_KINDS);
    for (int c = 0; c < all; c += all > 50 ? 7 : 1) { /* 7 has no factor in common with 3, 5, 11 */
        ndl_material *m = vector_material(model, c, 5, false);
        try_material(m, &p);
        char text[TEXT_ROOM];
        snprintf(text, sizeof text, "0.5*lambert + [0.1,0.2,0.3]*%s", ndl_material_text(m));
        ndl_material *sum = ndl_material_parse(text, NULL);
        if (c == 0) try_material(sum, &p);
        ndl_material_free(sum);
        ndl_material_free(m);
    }
}

int main(void) {
    int failed = run_over_models("instruction sets", every_instruction_set_gives_the_same_bits);
    return failed + run_over_models("batches", how_a_batch_is_cut_does_not_matter);
}
