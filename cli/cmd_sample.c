/* SPDX-License-Identifier: Apache-2.0 */
#include "base/stream.h"
#include "directions.h"
#include "draws.h"
#include "material.h"
#include "ndotl/convert.h"
#include "number_text.h"
#include "options.h"
#include "report.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const cli_option options[] = {
    {"--seed", "N", NULL, false,
     "where the random numbers of lines with three numbers begin, 0 to 2^53 - 1 (default 0)"},
    {"--binary", "f32", "f32", false,
     "read six little-endian float32 for each direction, wo and u, and write seven"},
    {NULL, NULL, NULL, false, NULL},
};

/* What was drawn for a batch. */
typedef struct {
    cli_draws in;
    float wi[3][CLI_BATCH], weight[3][CLI_BATCH], pdf[CLI_BATCH];
} batch;

/* The number that a reader makes of x: nine digits are near the float, not the float. */
static double as_read(float x, bool raw) {
    char text[CLI_PRINT_ROOM];
    double read = (double)x;
    if (!raw) cli_scan_double(text, text + cli_print_float(x, text), &read);
    return read;
}

/* The direction as `eval` reads it: normalised in double and rounded, until that changes nothing,
   so that --pdf gives the density that is printed beside it. Where rounding goes back and forth
   (one direction in thousands), a component moves to the next float. */
static ndl_vec3 settled(ndl_vec3 w, bool raw) {
    for (int k = 1; k < 64; k++) {
        ndl_vec3 next;
        ndl_direction(as_read(w.x, raw), as_read(w.y, raw), as_read(w.z, raw), &next);
        if (next.x == w.x && next.y == w.y && next.z == w.z) break;
        w = next;
        float *moved = k % 12 == 4 ? &w.x : k % 12 == 8 ? &w.y : &w.z;
        if (k % 4 == 0) *moved = nextafterf(*moved, 0.0f);
    }
    return w;
}

static void settle(batch *b, bool raw) {
    for (size_t i = 0; i < b->in.n; i++) {
        ndl_vec3 w = settled((ndl_vec3){b->wi[0][i], b->wi[1][i], b->wi[2][i]}, raw);
        b->wi[0][i] = w.x;
        b->wi[1][i] = w.y;
        b->wi[2][i] = w.z;
    }
}

static void draw(const ndl_material *m, batch *b, bool raw) {
    const cli_draws *in = &b->in;
    ndl_vec3_n wo = {in->wo[0], in->wo[1], in->wo[2]}, u = {in->u[0], in->u[1], in->u[2]};
    ndl_vec3_n wi = {b->wi[0], b->wi[1], b->wi[2]};
    ndl_rgb_n weight = {b->weight[0], b->weight[1], b->weight[2]};
    ndl_draw_n(m, in->n, wo, u, (ndl_vec3_out){b->wi[0], b->wi[1], b->wi[2]}, weight, b->pdf);
    settle(b, raw);
    ndl_brdf_cos_pdf_n(m, in->n, wi, wo, weight, b->pdf);
    for (int c = 0; c < 3; c++)
        for (size_t i = 0; i < in->n; i++) {
            float w = b->pdf[i] > 0.0f ? b->weight[c][i] / b->pdf[i] : 0.0f;
            b->weight[c][i] = w < FLT_MAX ? w : FLT_MAX;
        }
}

static char *put_raw(char *at, float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    for (int k = 0; k < 4; k++)
        *at++ = (char)(bits >> 8 * k & 255);
    return at;
}

/* wi.x wi.y wi.z r g b pdf of each lane. */
static int put(const batch *b, bool raw) {
    nd_text t = {0};
    for (size_t i = 0; i < b->in.n; i++) {
        const float v[7] = {b->wi[0][i],     b->wi[1][i],     b->wi[2][i], b->weight[0][i],
                            b->weight[1][i], b->weight[2][i], b->pdf[i]};
        char row[7 * (CLI_PRINT_ROOM + 1)], *at = row;
        for (int k = 0; k < 7; k++) {
            if (raw) {
                at = put_raw(at, v[k]);
                continue;
            }
            at += cli_print_float(v[k], at);
            *at++ = k < 6 ? ' ' : '\n';
        }
        nd_text_bytes(&t, row, (size_t)(at - row));
    }
    return cli_put_text("sample", &t);
}

static int stream(const cli_args *args, const ndl_material *m, long long seed, batch *b) {
    bool raw = cli_has(args, "--binary");
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL;
    cli_draw_source *source;
    int code = cli_draws_open("sample", path, raw, (uint64_t)seed, &source);
    if (code) return code;
    do {
        code = cli_draws_next(source, &b->in);
        if (code || !b->in.n) break;
        draw(m, b, raw);
        code = put(b, raw);
    } while (!code);
    cli_draws_close(source);
    return code;
}

static int run(const cli_args *args) {
    ndl_material *m = NULL;
    long long seed = 0;
    int code = cli_use_environment("sample");
    if (!code) code = cli_exclusive(args, "--seed", "--binary");
    if (!code) code = cli_integer(args, "--seed", 0, (1LL << 53) - 1, &seed);
    if (!code) code = cli_material("sample", NULL, args->operands[0], &m);
    if (code) return code;
    batch *b = calloc(1, sizeof *b);
    code = b ? stream(args, m, seed, b) : cli_error("sample", CLI_FAILED, NULL, "out of memory");
    free(b);
    ndl_material_free(m);
    return code;
}

const cli_command cli_sample = {
    .name = "sample",
    .summary = "directions drawn for a viewer, with weight and density",
    .usage = "MATERIAL [--seed N | --binary f32] [FILE]",
    .details =
        "Reads FILE, or stdin without FILE or with '-'. Each line has six numbers, wo.x wo.y wo.z "
        "u0 u1 u2, separated by blanks, tabs or commas; # starts a comment, empty lines are "
        "skipped. wo leaves the surface towards the viewer and is normalised; u are three numbers "
        "in [0, 1): the first two place the direction, the third chooses between lobes.\n"
        "A line with only wo takes its u from the seed: SplitMix64 begun at its own mix of N + "
        "0x9e3779b97f4a7c15, the upper 24 bits of three numbers for each row, in order; a row's "
        "numbers depend on N and its place among the rows alone, on every machine.\n"
        "Writes wi.x wi.y wi.z r g b pdf for each row with nine significant digits. r g b is the "
        "weight f cos / pdf, whose mean is the albedo; pdf, 1/sr, is what 'ndotl eval --pdf' gives "
        "for this wi and wo. pdf 0 means no sample: the weight is 0 then. All is 0 where wo.z <= "
        "0.\n",
    .example = "echo '0 0.6 0.8  0.3 0.7 0.5' | ndotl sample 'ggx(preset=gold, roughness=0.3)'\n"
               "yes '0 0.6 0.8' | head -1000 | ndotl sample beckmann --seed 7",
    .options = options,
    .least = 1,
    .most = 2,
    .operand = "MATERIAL",
    .run = run,
};
