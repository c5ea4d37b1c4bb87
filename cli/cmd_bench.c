/* SPDX-License-Identifier: Apache-2.0 */
#include "base/file.h"
#include "base/number.h"
#include "bench.h"
#include "material.h"
#include "options.h"
#include "report.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const cli_option options[] = {
    {"--op", "OP", "brdf pdf sample", false,
     "the operation; sample: direction, weight and pdf (default brdf)"},
    {"--isa", "ISA", NULL, false,
     "the instruction set: scalar, x86-64, x86-64-v3, x86-64-v4, neon, or all of this machine's "
     "(default: the one in use, see 'ndotl --version')"},
    {"--table", "TABLE", "exact fast", false, "the kernel table (default exact)"},
    {"--n", "N", NULL, true, "pairs in a batch; one row for each N, with uniform parameters"},
    {"--threads", "N", NULL, false,
     "so many threads at once, each with batches of N pairs; batches of 65536 pairs and more are "
     "shared by all (default 1)"},
    {"--time", "S", NULL, false, "seconds that a row may take, 0.001 to 60 (default 0.5)"},
    {"--json", NULL, NULL, false, "write {\"machine\",\"rows\"}"},
    {"-o", "FILE", NULL, false, "also write a bar chart, .svg"},
    {NULL, NULL, NULL, false, NULL},
};

static const char *const ISAS[] = {"scalar", "x86-64", "x86-64-v3", "x86-64-v4", "neon", "wasm"};
#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

enum { ISA_COUNT = sizeof ISAS / sizeof *ISAS, MOST_THREADS = 1024 };

/* A row: what was measured and what came out. */
typedef struct {
    bench_order order;
    bench_result result;
    bench_level level;
} row;

typedef struct {
    const cli_args *args;
    bench_machine machine;
    bench_limits limits;
    const bench_op *op;
    const char *isa[ISA_COUNT];
    size_t isa_count;
    int threads;
    double seconds;
    ndl_material **materials;
    size_t material_count;
    row *rows;
    size_t row_count;
    const char *chart; /* path, or NULL */
} job;

static void add(nd_text *t, const char *format, ...) CLI_FORMAT(2, 3);
static void add(nd_text *t, const char *format, ...) {
    char line[512];
    va_list values;
    va_start(values, format);
    vsnprintf(line, sizeof line, format, values);
    va_end(values);
    nd_text_add(t, line);
}

/* ---- the command line ------------------------------------------------------------------------ */

static int read_isa(job *j) {
    const char *word = cli_value(j->args, "--isa");
    if (word && strcmp(word, "all") == 0) {
        const char *used = ndl_isa();
        for (int i = 0; i < ISA_COUNT; i++)
            if (ndl_use_isa(ISAS[i]) == NDL_OK) j->isa[j->isa_count++] = ISAS[i];
        ndl_use_isa(used);
        return CLI_OK;
    }
    if (word && (!*word || ndl_use_isa(word) != NDL_OK))
        return cli_error("bench", CLI_USAGE, "--isa",
                         "'%s' is unknown or this machine lacks it; use all, or one of: scalar "
                         "x86-64 x86-64-v3 x86-64-v4 neon",
                         cli_quote(word).s);
    j->isa[j->isa_count++] = ndl_isa();
    return CLI_OK;
}

static int read_words(job *j) {
    const char *op = cli_value(j->args, "--op"), *table = cli_value(j->args, "--table");
    j->op = bench_op_find(op ? op : "brdf");
    if (table && strcmp(table, "fast") == 0)
        return cli_error("bench", CLI_USAGE, "--table", "'fast' is not in this version; use exact");
    j->chart = cli_value(j->args, "-o");
    size_t length = j->chart ? strlen(j->chart) : 0;
    if (j->chart && (length < 5 || strcmp(j->chart + length - 4, ".svg") != 0))
        return cli_error("bench", CLI_USAGE, "-o", "'%s': the chart is an .svg file",
                         cli_quote(j->chart).s);
    long long threads = 1;
    j->seconds = 0.5;
    int code = cli_integer(j->args, "--threads", 1, MOST_THREADS, &threads);
    if (!code) code = cli_number(j->args, "--time", 0.001, 60.0, &j->seconds);
    j->threads = (int)threads;
    return code ? code : read_isa(j);
}

/* The materials named, or every model with its defaults. */
static int read_materials(job *j) {
    size_t given = j->args->operand_count, count = given ? given : ndl_model_count();
    j->materials = calloc(count, sizeof *j->materials);
    if (!j->materials) return cli_error("bench", CLI_FAILED, NULL, "out of memory");
    for (size_t i = 0; i < count; i++) {
        const char *text = given ? j->args->operands[i] : ndl_model_name(i);
        int code =
            cli_material("bench", given > 1 ? cli_quote(text).s : NULL, text, &j->materials[i]);
        if (code) return code;
        j->material_count++;
    }
    return CLI_OK;
}

static void add_row(job *j, const ndl_material *m, const char *isa, size_t n, bool lanes) {
    row *r = &j->rows[j->row_count++];
    r->order = (bench_order){.material = m,
                             .op = j->op,
                             .isa = isa,
                             .n = n,
                             .threads = j->threads,
                             .has_lanes = lanes,
                             .seconds = j->seconds};
    r->level = bench_level_of(&j->machine, n, j->op->bytes);
}

/* With --n one row for each; else the three levels, with uniform and with varying parameters. */
static int plan(job *j) {
    enum { MOST_SIZES = 64 };
    size_t sizes[MOST_SIZES], count = 0;
    const char *text;
    bool levels = !cli_has(j->args, "--n");
    for (size_t i = 0; (text = cli_nth(j->args, "--n", i)) != NULL; i++, count++) {
        double n = 0.0;
        size_t digits = strspn(text, "0123456789");
        if (!text[digits]) nd_parse_double(text, digits, &n);
        if (n < 1.0 || n > 1e9)
            return cli_error("bench", CLI_USAGE, "--n",
                             "'%s' is not an integer from 1 to 1000000000", cli_quote(text).s);
        if (count == MOST_SIZES)
            return cli_error("bench", CLI_USAGE, "--n", "at most %d sizes", MOST_SIZES);
        sizes[count] = (size_t)n;
    }
    for (; levels && count < BENCH_LEVELS; count++)
        sizes[count] = bench_level_pairs(&j->machine, (bench_level)count, j->op->bytes);
    bool lanes = levels && j->op->lanes;
    j->rows = calloc(j->material_count * j->isa_count * count * 2, sizeof *j->rows);
    if (!j->rows) return cli_error("bench", CLI_FAILED, NULL, "out of memory");
    for (size_t m = 0; m < j->material_count; m++)
        for (size_t k = 0; k < j->isa_count; k++)
            for (size_t i = 0; i < count; i++)
                for (int varying = 0; varying <= lanes; varying++)
                    add_row(j, j->materials[m], j->isa[k], sizes[i], varying);
    return CLI_OK;
}

/* ---- results --------------------------------------------------------------------------------- */

/* The share of the stream limit that a row reaches: the same bytes moved without computing. */
static double share_of_stream(const job *j, const row *r) {
    double bytes = (double)(r->order.op->bytes + r->result.lanes * sizeof(float));
    return r->result.meval_per_s * bytes / (j->limits.stream[r->level] * BENCH_EVAL_BYTES);
}

static void add_machine(const job *j, nd_text *t) {
    const bench_machine *m = &j->machine;
    const bench_limits *l = &j->limits;
    add(t, "%s, %d processor%s, caches %zu KiB, %zu KiB, %zu KiB; %s\n", m->cpu, m->processors,
        m->processors == 1 ? "" : "s", m->cache[1] >> 10, m->cache[2] >> 10, m->cache[3] >> 10,
        COMPILER);
    add(t,
        "limits of %d thread%s, %s: FMA %.4g Gflop/s; triad %.3g GB/s; streams of 6 reads and 3 "
        "writes %.4g (L1), %.4g (L2), %.4g (DRAM) M/s\n",
        j->threads, j->threads == 1 ? "" : "s", l->isa, l->fma, l->triad, l->stream[BENCH_L1],
        l->stream[BENCH_L2], l->stream[BENCH_DRAM]);
    nd_text_add(t, "flop: what the FMA peak could compute in the time of one evaluation; stream: "
                   "share of the stream limit of that level\n\n");
}

static void write_table(const job *j, nd_text *t) {
    add_machine(j, t);
    const ndl_material *before = NULL;
    for (size_t i = 0; i < j->row_count; i++) {
        const row *r = &j->rows[i];
        const bench_order *o = &r->order;
        if (o->material != before) {
            nd_text_add(t, ndl_material_text(o->material));
            add(t, "\n  %-6s %-10s %-7s %-5s %10s %10s %9s %9s %7s %7s\n", "op", "isa", "params",
                "level", "n", "M/s", "ns", "vs scalar", "flop", "stream");
        }
        before = o->material;
        add(t, "  %-6s %-10s %-7s %-5s %10zu %10.1f %9.3f %9.2f %7.1f %6.1f%%\n", o->op->name,
            o->isa, o->has_lanes ? "lanes" : "uniform", bench_level_names[r->level], o->n,
            r->result.meval_per_s, 1e3 / r->result.meval_per_s, r->result.vs_scalar,
            1e3 * j->limits.fma / r->result.meval_per_s, 100.0 * share_of_stream(j, r));
    }
}

static void write_json(const job *j, nd_text *t) {
    const bench_machine *m = &j->machine;
    const bench_limits *l = &j->limits;
    nd_text_add(t, "{\"machine\":{\"cpu\":");
    nd_text_json(t, m->cpu);
    nd_text_add(t, ",\"compiler\":");
    nd_text_json(t, COMPILER);
    add(t, ",\"processors\":%d,\"l1_kib\":%zu,\"l2_kib\":%zu,\"l3_kib\":%zu,", m->processors,
        m->cache[1] >> 10, m->cache[2] >> 10, m->cache[3] >> 10);
    add(t, "\"limits_isa\":\"%s\",\"fma_gflop_per_s\":%.6g,\"triad_gb_per_s\":%.6g,", l->isa,
        l->fma, l->triad);
    add(t, "\"stream_m_per_s\":{\"L1\":%.6g,\"L2\":%.6g,\"DRAM\":%.6g}},\n\"rows\":[",
        l->stream[BENCH_L1], l->stream[BENCH_L2], l->stream[BENCH_DRAM]);
    for (size_t i = 0; i < j->row_count; i++) {
        const row *r = &j->rows[i];
        const bench_order *o = &r->order;
        nd_text_add(t, i ? ",\n{\"material\":" : "\n{\"material\":");
        nd_text_json(t, ndl_material_text(o->material));
        add(t, ",\"op\":\"%s\",\"isa\":\"%s\",\"table\":\"exact\",\"n\":%zu,\"threads\":%d,",
            o->op->name, o->isa, o->n, o->threads);
        add(t, "\"level\":\"%s\",\"params\":\"%s\",", bench_level_names[r->level],
            o->has_lanes ? "lanes" : "uniform");
        add(t, "\"meval_per_s\":%.6g,\"ns\":%.6g,\"vs_scalar\":%.6g}", r->result.meval_per_s,
            1e3 / r->result.meval_per_s, r->result.vs_scalar);
    }
    nd_text_add(t, "\n]}\n");
}

static int write_chart(const job *j) {
    enum { LABEL = 160 };
    char(*label)[LABEL] = calloc(j->row_count, sizeof *label);
    bench_bar *bars = calloc(j->row_count, sizeof *bars);
    nd_text svg = {0};
    ndl_error error = {0};
    for (size_t i = 0; label && bars && i < j->row_count; i++) {
        const row *r = &j->rows[i];
        const bench_order *o = &r->order;
        snprintf(label[i], LABEL, "%.34s%s %s %s %s", ndl_material_text(o->material),
                 strlen(ndl_material_text(o->material)) > 34 ? "..." : "", o->isa,
                 bench_level_names[r->level], o->has_lanes ? "lanes" : "uniform");
        bars[i] = (bench_bar){label[i], r->result.meval_per_s};
    }
    if (label && bars) bench_chart(&svg, "ndotl bench", "evaluations (1e6/s)", bars, j->row_count);
    int code = CLI_OK;
    if (!label || !bars || svg.failed)
        code = cli_error("bench", CLI_FAILED, NULL, "out of memory");
    else if (!nd_file_replace(j->chart, svg.s, svg.n, &error))
        code = cli_error("bench", CLI_FAILED, cli_quote(j->chart).s, "%s", error.text);
    nd_text_free(&svg);
    free(label);
    free(bars);
    return code;
}

static int measure(job *j) {
    bench_batches batches = {0};
    double seconds = j->seconds < 0.5 ? 0.2 * j->seconds : 0.1;
    bool good = bench_limits_measure(&j->machine, j->threads, seconds, &j->limits);
    for (size_t i = 0; good && i < j->row_count; i++)
        good = bench_row_measure(&j->rows[i].order, &batches, &j->rows[i].result);
    bench_batches_free(&batches);
    if (good) return CLI_OK;
    return cli_error("bench", CLI_FAILED, NULL,
                     "not enough memory, or fewer threads than %d; lower --n or --threads",
                     j->threads);
}

static int run_job(job *j) {
    int code = read_words(j);
    if (!code) code = read_materials(j);
    if (!code) code = plan(j);
    if (!code) code = measure(j);
    if (code) return code;
    nd_text t = {0};
    if (cli_has(j->args, "--json"))
        write_json(j, &t);
    else
        write_table(j, &t);
    code = cli_put_text("bench", &t);
    return code || !j->chart ? code : write_chart(j);
}

static int run(const cli_args *args) {
    job j = {.args = args};
    int code = cli_use_environment("bench");
    if (code) return code;
    bench_machine_read(&j.machine);
    code = run_job(&j);
    for (size_t i = 0; i < j.material_count; i++)
        ndl_material_free(j.materials[i]);
    free(j.materials);
    free(j.rows);
    return code;
}

const cli_command cli_bench = {
    .name = "bench",
    .summary =
        "how many evaluations a second this machine makes, and how close that is to its limits",
    .usage = "[MATERIAL]... [--op brdf|pdf|sample] [--isa ISA|all] [--table exact|fast]\n"
             "[--n N]... [--threads N] [--time S] [--json] [-o chart.svg]",
    .details =
        "Times whole public batch calls on random pairs of directions, 90 % of them with both "
        "above "
        "the horizon; without MATERIAL every model with its defaults. Without --n three sizes are "
        "taken, for the first cache (L1), the second (L2) and memory (DRAM: all that the second "
        "cannot hold), each with uniform parameters and with up to five parameters that differ "
        "from "
        "pair to pair (lanes).\n"
        "'vs scalar' compares with the library's own formulas as one scalar loop, measured in "
        "turns. The limits are measured on the spot: multiply-adds from registers, and streams "
        "that "
        "read six arrays and write three, as an evaluation does.\n"
        "Other work on the machine changes the numbers; pin the program to a quiet core, as in "
        "'taskset -c 1 ndotl bench ggx'.\n",
    .example = "ndotl bench ggx 'ggx(preset=gold)' --isa all -o bench.svg\n"
               "ndotl bench ggx --n 16384 --threads 2 --time 0.1 --json",
    .options = options,
    .least = 0,
    .most = 64,
    .operand = NULL,
    .run = run,
};
