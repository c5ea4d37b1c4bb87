/* SPDX-License-Identifier: Apache-2.0 */
/* Measures on request, so that a driver can take turns between programs. Each line of stdin is one
   request, each answered by one line: evaluations per second, or text.

       brdf|cos|pdf|sample ISA N SECONDS MATERIAL   batch calls of N pairs
       lanes ISA N SECONDS KEY,KEY MATERIAL         the same, these parameters per lane
       threads T N SECONDS MATERIAL                 ndl_brdf_threads_n
       call ISA SECONDS MATERIAL                    ndl_brdf, one pair after the other
       one ISA SECONDS MATERIAL                     the same by ndl_brdf_n with n = 1
       own NAME N SECONDS                           a kernel of flagship.h
       error NAME N                                 its largest relative difference from ndl_brdf_n
       material                                     the flagship as text */
#include "flagship.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST = 1 << 22, ARRAYS = 24, SKEW = 80, WORD = 4096 };

static const flagship P = {0.15f, 0.35f, {0.95f, 0.64f, 0.54f}};
static const char MATERIAL[] = "ggx(alpha_x=0.15, alpha_y=0.35, f0=[0.95,0.64,0.54])";

static const struct {
    const char *name;
    flagship_kernel *run;
    const char *isa;
} OWN[] = {
    {"ceiling_v4_exact", ceiling_v4_exact, "x86-64-v4"},
    {"ceiling_v4_fast", ceiling_v4_fast, "x86-64-v4"},
    {"ceiling_v4_mixed", ceiling_v4_mixed, "x86-64-v4"},
    {"ceiling_v3_exact", ceiling_v3_exact, "x86-64-v3"},
    {"ceiling_v3_fast", ceiling_v3_fast, "x86-64-v3"},
    {"ceiling_v3_mixed", ceiling_v3_mixed, "x86-64-v3"},
    {"naive_plain", naive_plain, "x86-64"},
    {"naive_v3", naive_v3, "x86-64-v3"},
    {"naive_v4", naive_v4, "x86-64-v4"},
};

/* 0-5 directions, 6-8 random numbers, 9-15 results, 16-18 more results, 19-23 lanes. */
static float *array[ARRAYS];

static float uniform(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (float)(*state >> 40) * 0x1p-24f;
}

static void direction(uint64_t *state, float up, size_t i, float **w) {
    float x, y, z, l;
    do {
        x = 2.0f * uniform(state) - 1.0f;
        y = 2.0f * uniform(state) - 1.0f;
        z = uniform(state);
        l = x * x + y * y + z * z;
    } while (l > 1.0f || l < 1e-3f);
    l = up / sqrtf(l);
    w[0][i] = x * l;
    w[1][i] = y * l;
    w[2][i] = z * l;
}

/* 90 % of the pairs have both directions above the horizon. */
static int fill(void) {
    size_t room = MOST + SKEW;
    char *memory = calloc(ARRAYS * room + 16, sizeof(float));
    uint64_t state = 88172645463325252ULL;
    if (!memory) return 0;
    memory += (64 - (uintptr_t)memory % 64) % 64;
    for (size_t k = 0; k < ARRAYS; k++)
        array[k] = (float *)(void *)memory + k * room;
    for (size_t i = 0; i < MOST; i++) {
        float kind = uniform(&state);
        direction(&state, kind < 0.934f ? 1.0f : -1.0f, i, array);
        direction(&state, kind < 0.9f || kind > 0.967f ? 1.0f : -1.0f, i, array + 3);
        for (int k = 6; k < 9; k++)
            array[k][i] = uniform(&state);
        for (int k = 9; k < 19; k++)
            array[k][i] = 0.0f;
        for (int k = 19; k < ARRAYS; k++)
            array[k][i] = 0.2f + 0.6f * uniform(&state);
    }
    return 1;
}

typedef struct {
    const char *op;
    const ndl_material *m;
    flagship_kernel *own;
    ndl_lanes lane[5];
    size_t lanes, n;
    int threads;
} request;

static void call(const request *q) {
    ndl_vec3_n wi = {array[0], array[1], array[2]}, wo = {array[3], array[4], array[5]};
    ndl_vec3_n u = {array[6], array[7], array[8]};
    ndl_rgb_n rgb = {array[9], array[10], array[11]};
    ndl_vec3_out drawn = {array[12], array[13], array[14]};
    if (q->own)
        q->own(&P, q->n, wi, wo, rgb);
    else if (q->threads)
        ndl_brdf_threads_n(q->m, q->threads, q->n, wi, wo, rgb);
    else if (q->lanes)
        ndl_brdf_lanes_n(q->m, q->lanes, q->lane, q->n, wi, wo, rgb);
    else if (strcmp(q->op, "cos") == 0)
        ndl_brdf_cos_n(q->m, q->n, wi, wo, rgb);
    else if (strcmp(q->op, "pdf") == 0)
        ndl_pdf_n(q->m, q->n, wi, wo, array[9]);
    else if (strcmp(q->op, "sample") == 0)
        ndl_draw_n(q->m, q->n, wo, u, drawn, rgb, array[15]);
    else
        ndl_brdf_n(q->m, q->n, wi, wo, rgb);
}

static volatile float sink;

static void single(const request *q) {
    float sum = 0.0f;
    for (size_t i = 0; i < q->n; i++) {
        ndl_vec3 wi = {array[0][i], array[1][i], array[2][i]};
        ndl_vec3 wo = {array[3][i], array[4][i], array[5][i]};
        sum += ndl_brdf(q->m, wi, wo).r;
    }
    sink = sum;
}

static void batches_of_one(const request *q) {
    float sum = 0.0f;
    ndl_rgb f;
    for (size_t i = 0; i < q->n; i++) {
        ndl_brdf_n(q->m, 1, (ndl_vec3_n){array[0] + i, array[1] + i, array[2] + i},
                   (ndl_vec3_n){array[3] + i, array[4] + i, array[5] + i},
                   (ndl_rgb_n){&f.r, &f.g, &f.b});
        sum += f.r;
    }
    sink = sum;
}

static double clock_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Evaluations per second over about `seconds`, after one call that warms up. */
static double rate(const request *q, void (*run)(const request *), double seconds) {
    size_t calls = 0, chunk = 1;
    run(q);
    double start = clock_now(), before = start, now;
    for (;;) {
        for (size_t i = 0; i < chunk; i++)
            run(q);
        calls += chunk;
        now = clock_now();
        if (now - start >= seconds) break;
        if (now - before < 0.03 * seconds) chunk *= 2;
        before = now;
    }
    sink = array[9][q->n - 1];
    return (double)(calls * q->n) / (now - start);
}

static double largest_difference(flagship_kernel *own, size_t n) {
    ndl_material *m = ndl_material_parse(MATERIAL, NULL);
    request q = {.op = "brdf", .m = m, .n = n};
    double most = 0.0;
    ndl_use_isa("");
    call(&q);
    for (int k = 0; k < 3; k++)
        memcpy(array[16 + k], array[9 + k], n * sizeof(float));
    q.own = own;
    call(&q);
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < n; i++) {
            double want = (double)array[16 + k][i], off = fabs((double)array[9 + k][i] - want);
            if (!(off <= most * (want + 1e-20))) most = off / (want + 1e-20);
        }
    ndl_material_free(m);
    return most;
}

static int find_own(const char *name) {
    for (size_t i = 0; i < sizeof OWN / sizeof *OWN; i++)
        if (strcmp(OWN[i].name, name) == 0) return ndl_use_isa(OWN[i].isa) == NDL_OK ? (int)i : -1;
    return -1;
}

/* Next word of the request, ended; the rest stays in *at. */
static char *word(char **at) {
    char *begin = *at + strspn(*at, " "), *end = begin + strcspn(begin, " ");
    *at = *end ? end + 1 : end;
    *end = '\0';
    return begin;
}

static void answer_own(const char *op, char *line) {
    int own = find_own(word(&line));
    request q = {.op = op, .n = strtoul(word(&line), NULL, 10)};
    double seconds = strtod(word(&line), NULL), result = 0.0;
    if (own >= 0) q.own = OWN[own].run;
    if (own >= 0 && q.n && q.n <= MOST)
        result =
            strcmp(op, "error") == 0 ? largest_difference(q.own, q.n) : rate(&q, call, seconds);
    printf("%.9g\n", own < 0 ? (double)NAN : result);
}

static void answer_library(const char *op, char *line) {
    request q = {.op = op};
    const char *isa = "";
    char *keys = NULL;
    ndl_error error = {0};
    if (strcmp(op, "threads") == 0)
        q.threads = atoi(word(&line));
    else
        isa = word(&line);
    bool calls = strcmp(op, "call") == 0, ones = strcmp(op, "one") == 0;
    q.n = calls || ones ? 64 : strtoul(word(&line), NULL, 10);
    double seconds = strtod(word(&line), NULL);
    if (strcmp(op, "lanes") == 0) keys = word(&line);
    for (char *key = keys; key && *key && q.lanes < 5; q.lanes++) {
        char *comma = key + strcspn(key, ",");
        q.lane[q.lanes] = (ndl_lanes){key, array[19 + q.lanes]};
        key = *comma ? comma + 1 : comma;
        *comma = '\0';
    }
    ndl_material *m = ndl_material_parse(line, &error);
    q.m = m;
    if (!m || ndl_use_isa(isa) != NDL_OK || !q.n || q.n > MOST ||
        (q.lanes && ndl_lanes_check(m, q.lanes, q.lane, &error)))
        printf("nan %s\n", error.text);
    else
        printf("%.9g\n", rate(&q, calls ? single : ones ? batches_of_one : call, seconds));
    ndl_material_free(m);
}

int main(void) {
    static char text[WORD];
    if (!fill()) return 1;
    while (fgets(text, sizeof text, stdin)) {
        char *line = text;
        line[strcspn(line, "\n")] = '\0';
        const char *op = word(&line);
        if (strcmp(op, "material") == 0)
            puts(MATERIAL);
        else if (strcmp(op, "own") == 0 || strcmp(op, "error") == 0)
            answer_own(op, line);
        else
            answer_library(op, line);
        fflush(stdout);
    }
    return 0;
}
