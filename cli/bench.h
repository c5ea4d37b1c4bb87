/* SPDX-License-Identifier: Apache-2.0 */
/* What `ndotl bench` measures with: batches of directions, rates, the machine and its limits. */
#ifndef NDOTL_CLI_BENCH_H
#define NDOTL_CLI_BENCH_H
#include "base/text.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    BENCH_INPUTS = 6,
    BENCH_OUTPUTS = 7,
    BENCH_LANES = 5,
    BENCH_RANDOM = 3,
    BENCH_EVAL_BYTES = 36 /* of an evaluation: six floats read, three written */
};

/* n pairs of directions, room for results, parameters per lane, and random numbers in [0, 1). The
   arrays do not overlap, each begins at a multiple of 64 bytes, and they are spread over the sets
   of the first cache. */
typedef struct {
    size_t n;
    float *in[BENCH_INPUTS], *out[BENCH_OUTPUTS], *lane[BENCH_LANES], *random[BENCH_RANDOM];
    void *memory;
} bench_batch;

/* Fills a batch: pairs from `seed`, 90 % of them with both directions above the horizon.
   false when memory is out. */
bool bench_batch_new(bench_batch *b, size_t n, unsigned seed);
void bench_batch_free(bench_batch *b);
/* Pairs [n i/parts, n (i+1)/parts) of a batch, in whole groups of 16; part of the same memory. */
bench_batch bench_batch_part(const bench_batch *b, int i, int parts);

/* Calls per second of call(context, thread) over about `seconds`, at least one call a thread, by
   `threads` threads at once, all together. 0 when the system gives fewer threads. */
typedef void bench_call(void *context, int thread);
double bench_rate(bench_call *call, void *context, int threads, double seconds);

double bench_median(double *values, size_t n);

typedef struct {
    char cpu[80];
    int processors;
    size_t cache[4]; /* bytes of level 1 (data), 2 and 3; [0] unused */
} bench_machine;
void bench_machine_read(bench_machine *m);

typedef enum { BENCH_L1, BENCH_L2, BENCH_DRAM, BENCH_LEVELS } bench_level;
extern const char *const bench_level_names[BENCH_LEVELS];
/* The level that holds n pairs of `bytes` each; DRAM is all that the second cache cannot hold. */
bench_level bench_level_of(const bench_machine *m, size_t n, size_t bytes);
/* A number of pairs for a level: half of that cache's bytes, or four times those of the third. */
size_t bench_level_pairs(const bench_machine *m, bench_level level, size_t bytes);

/* What the machine can do at most, with the instruction set named. */
typedef struct {
    const char *isa;
    double fma;                  /* 1e9 flop/s, an fma counted as two */
    double triad;                /* 1e9 bytes/s of a[i] = b[i] + s c[i] from DRAM */
    double stream[BENCH_LEVELS]; /* 1e6/s: six reads and three writes, as an evaluation has */
} bench_limits;
/* false when memory is out or the system gives fewer threads. */
bool bench_limits_measure(const bench_machine *m, int threads, double seconds, bench_limits *to);

/* ---- rows ------------------------------------------------------------------------------------ */

/* An operation of the library. */
typedef struct {
    const char *name;
    size_t bytes; /* read and written for a pair, without parameters per lane */
    void (*uniform)(const ndl_material *m, const bench_batch *b);
    void (*lanes)(const ndl_material *m, size_t lanes, const ndl_lanes *lane, const bench_batch *b);
    void (*threads)(const ndl_material *m, int threads, const bench_batch *b);
    /* lanes, threads: NULL where the library has no such form of it */
} bench_op;
const bench_op *bench_op_find(const char *name);

/* What to measure. */
typedef struct {
    const ndl_material *material;
    const bench_op *op;
    const char *isa;
    size_t n;
    int threads;
    bool has_lanes;
    double seconds; /* at most, the comparison with scalar included */
} bench_order;

typedef struct {
    double meval_per_s; /* of all threads together */
    double vs_scalar;   /* over the scalar kernel of the same operation, measured in turns */
    size_t lanes;       /* arrays of parameters that were read */
} bench_result;

/* The batches of a row: for one thread or a large n one, else one for each thread. Keeps those of
   the row before where it can; {0} is empty. */
typedef struct {
    bench_batch *own;
    int count;
    size_t n;
} bench_batches;

/* false when memory is out or the system gives fewer threads. */
bool bench_row_measure(const bench_order *o, bench_batches *b, bench_result *to);
void bench_batches_free(bench_batches *b);

/* A bar chart in SVG of labelled values. */
typedef struct {
    const char *label;
    double value;
} bench_bar;
void bench_chart(nd_text *svg, const char *title, const char *unit, const bench_bar *bars,
                 size_t n);

#endif
