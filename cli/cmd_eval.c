/* SPDX-License-Identifier: Apache-2.0 */
#include "directions.h"
#include "material.h"
#include "options.h"
#include "report.h"
#include "table.h"

#include <stdlib.h>
#include <string.h>

static const cli_option options[] = {
    {"--cos", NULL, NULL, false, "multiply by wi.z: brdf_cos instead of brdf"},
    {"--term", "D|G|V|F", "D G V F", false,
     "one factor of a microfacet model instead: distribution, masking-shadowing, "
     "V = G/(4 NoL NoV), Fresnel"},
    {"--pdf", NULL, NULL, false,
     "the density with which 'ndotl sample' draws wi for wo instead, 1/sr"},
    {"--convention", "NAME", "radiometric scanline", false,
     "scanline: the lecture's quantity, cosine inside and no 1/pi in lambert and oren_nayar; never "
     "clamped (default radiometric)"},
    {"--angles", NULL, NULL, false,
     "lines have four angles in degrees: theta_i phi_i theta_o phi_o"},
    {"--wi-deg", "T,P", NULL, false, "one direction to the light, by angles; reads no input"},
    {"--wo-deg", "T,P", NULL, false, "one direction to the viewer, by angles"},
    {"--csv", NULL, NULL, false, "write a header, the directions and the values"},
    {"--json", NULL, NULL, false,
     "write {\"material\",\"quantity\",\"unit\",\"rows\"}; with --print the material's long form"},
    {"--binary", "f32|npy", "f32 npy", false,
     "f32: read and write little-endian float32 without a header; npy: write a .npy array"},
    {"--print", NULL, NULL, false, "print the material in canonical form and read nothing"},
    {NULL, NULL, NULL, false, NULL},
};

typedef struct {
    const char *name, *unit;
    size_t columns;
    void (*batch)(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo, ndl_rgb_n rgb);
    ndl_term_kind term; /* where batch is NULL */
} quantity;

static void pdf_batch(const ndl_material *m, size_t n, ndl_vec3_n wi, ndl_vec3_n wo,
                      ndl_rgb_n rgb) {
    ndl_pdf_n(m, n, wi, wo, rgb.r);
}

static const quantity brdf = {"brdf", "1/sr", 3, ndl_brdf_n, NDL_TERM_D};
static const quantity brdf_cos = {"brdf_cos", "1/sr", 3, ndl_brdf_cos_n, NDL_TERM_D};
static const quantity scanline = {"scanline", "1/sr", 3, ndl_scanline_n, NDL_TERM_D};
static const quantity pdf = {"pdf", "1/sr", 1, pdf_batch, NDL_TERM_D};
static const quantity terms[] = {
    {"D", "1/sr", 1, NULL, NDL_TERM_D},
    {"G", "1", 1, NULL, NDL_TERM_G},
    {"V", "1", 1, NULL, NDL_TERM_V},
    {"F", "1", 3, NULL, NDL_TERM_F},
};

static const quantity *chosen(const cli_args *args) {
    const char *term = cli_value(args, "--term"), *convention = cli_value(args, "--convention");
    for (size_t i = 0; term && i < sizeof terms / sizeof *terms; i++)
        if (strcmp(terms[i].name, term) == 0) return &terms[i];
    if (cli_has(args, "--pdf")) return &pdf;
    if (convention && strcmp(convention, "scanline") == 0) return &scanline;
    return cli_has(args, "--cos") ? &brdf_cos : &brdf;
}

static int check(const cli_args *args) {
    static const char *const pairs[][2] = {
        {"--term", "--cos"},         {"--term", "--convention"}, {"--csv", "--json"},
        {"--csv", "--binary"},       {"--json", "--binary"},     {"--angles", "--wi-deg"},
        {"--angles", "--wo-deg"},    {"--print", "--wi-deg"},    {"--print", "--csv"},
        {"--print", "--binary"},     {"--print", "--term"},      {"--print", "--cos"},
        {"--print", "--convention"}, {"--print", "--angles"},    {"--print", "--wo-deg"},
        {"--pdf", "--cos"},          {"--pdf", "--term"},        {"--pdf", "--convention"},
        {"--print", "--pdf"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        int code = cli_exclusive(args, pairs[i][0], pairs[i][1]);
        if (code) return code;
    }
    bool wi = cli_has(args, "--wi-deg"), wo = cli_has(args, "--wo-deg");
    if (wi != wo)
        return cli_error("eval", CLI_USAGE, wi ? "--wo-deg" : "--wi-deg",
                         "missing; give both directions");
    if ((wi || cli_has(args, "--print")) && args->operand_count > 1)
        return cli_error("eval", CLI_USAGE, cli_quote(args->operands[1]).s,
                         "unexpected: with %s no input is read", wi ? "--wi-deg" : "--print");
    return CLI_OK;
}

static int check_term(const ndl_material *m, const quantity *q) {
    if (q->batch || ndl_has_term(m, q->term)) return CLI_OK;
    if (ndl_material_lobes(m) > 1)
        return cli_error("eval", CLI_USAGE, "--term",
                         "a sum has no %s of its own; give one of its lobes alone", q->name);
    return cli_error("eval", CLI_USAGE, "--term",
                     "%s has no %s; the microfacet models have: microfacet, ggx, beckmann",
                     ndl_material_model(m, 0), q->name);
}

static int print_material(const cli_args *args, const ndl_material *m) {
    nd_text t = {0};
    nd_text_add(&t, cli_has(args, "--json") ? ndl_material_json(m) : ndl_material_text(m));
    nd_text_add(&t, "\n");
    return cli_put_text("eval", &t);
}

/* Two buffers of a batch: what is read and what is made of it. */
typedef struct {
    cli_pairs pairs;
    float r[CLI_BATCH], g[CLI_BATCH], b[CLI_BATCH];
} batch;

static int evaluate(const ndl_material *m, const quantity *q, batch *b, cli_table *table) {
    cli_pairs *p = &b->pairs;
    ndl_vec3_n wi = {p->ix, p->iy, p->iz}, wo = {p->ox, p->oy, p->oz};
    ndl_rgb_n rgb = {b->r, b->g, b->b};
    if (q->batch) q->batch(m, p->n, wi, wo, rgb);
    else ndl_term_n(m, q->term, p->n, wi, wo, rgb);
    return cli_table_add(table, p, rgb);
}

/* The pair of --wi-deg and --wo-deg. */
static int one_pair(const cli_args *args, cli_pairs *pairs) {
    double v[4], off;
    int code = cli_numbers(args, "--wi-deg", 2, v);
    if (!code) code = cli_numbers(args, "--wo-deg", 2, v + 2);
    if (!code) cli_pairs_add(pairs, v, true, &off);
    return code;
}

static cli_table_format format_of(const cli_args *args, bool npy_input) {
    const char *binary = cli_value(args, "--binary");
    if (cli_has(args, "--csv")) return CLI_CSV;
    if (cli_has(args, "--json")) return CLI_JSON;
    if (binary) return strcmp(binary, "f32") == 0 ? CLI_RAW : CLI_NPY;
    return npy_input ? CLI_NPY : CLI_LINES;
}

static int stream(const cli_args *args, const ndl_material *m, const quantity *q, batch *b,
                  cli_table *table) {
    const char *binary = cli_value(args, "--binary");
    bool raw = binary && strcmp(binary, "f32") == 0;
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL;
    cli_source *source;
    int code = cli_source_open("eval", path, raw, cli_has(args, "--angles"), &source);
    if (code) return code;
    table->format = format_of(args, cli_source_is_npy(source));
    cli_table_begin(table);
    do {
        code = cli_source_next(source, &b->pairs);
        if (!code && b->pairs.n) code = evaluate(m, q, b, table);
    } while (!code && b->pairs.n);
    cli_source_close(source);
    return code ? code : cli_table_end(table);
}

static int run_material(const cli_args *args, const ndl_material *m, batch *b) {
    const quantity *q = chosen(args);
    int code = check_term(m, q);
    if (code || cli_has(args, "--print")) return code ? code : print_material(args, m);
    cli_table table = {.verb = "eval",
                       .material = ndl_material_text(m),
                       .quantity = q->name,
                       .unit = q->unit,
                       .columns = q->columns};
    if (cli_has(args, "--wi-deg")) {
        code = one_pair(args, &b->pairs);
        if (code) return code;
        table.format = format_of(args, false);
        cli_table_begin(&table);
        code = evaluate(m, q, b, &table);
        if (!code) code = cli_table_end(&table);
    } else {
        code = stream(args, m, q, b, &table);
    }
    nd_text_free(&table.text);
    return code;
}

static int run(const cli_args *args) {
    ndl_material *m = NULL;
    int code = cli_use_environment("eval");
    if (!code) code = check(args);
    if (!code) code = cli_material("eval", NULL, args->operands[0], &m);
    if (code) return code;
    batch *b = calloc(1, sizeof *b);
    code = b ? run_material(args, m, b) : cli_error("eval", CLI_FAILED, NULL, "out of memory");
    free(b);
    ndl_material_free(m);
    return code;
}

const cli_command cli_eval = {
    .name = "eval",
    .summary = "values of a material for pairs of directions",
    .usage = "MATERIAL [--cos | --pdf | --term D|G|V|F]\n"
             "[--convention radiometric|scanline]\n"
             "[--angles | --wi-deg T,P --wo-deg T,P]\n"
             "[--csv | --json | --binary f32|npy] [FILE]\n"
             "MATERIAL --print [--json]",
    .details =
        "Reads FILE, or stdin without FILE or with '-'. Each line has six numbers, wi.x wi.y wi.z "
        "wo.x wo.y wo.z, separated by blanks, tabs or commas; # starts a comment, empty lines are "
        "skipped. Directions leave the surface: n is (0,0,1), wi points to the light, wo to the "
        "viewer; they are normalised.\n"
        "Writes r g b for each line, or one number for the terms D, G and V, with nine significant "
        "digits. A value is 0 unless wi.z > 0 and wo.z > 0.\n"
        "A .npy array (rows of six or four columns, float32 or float64) is recognised by its first "
        "bytes; it gives a .npy array of float32.\n",
    .example = "echo '0 0.6 0.8  0 -0.6 0.8' | ndotl eval 'ggx(preset=gold, roughness=0.3)'\n"
               "ndotl eval lambert --wi-deg 30,0 --wo-deg 45,180 --cos",
    .options = options,
    .least = 1,
    .most = 2,
    .operand = "MATERIAL",
    .run = run,
};
