/* SPDX-License-Identifier: Apache-2.0 */
/* Which kernel tables are used: the best ones that this machine runs, or those asked for. */
#include "base/error.h"
#include "core/draw.h"

#include <stdatomic.h>
#include <string.h>

static bool always(void) {
    return true;
}

extern const nd_kernel_table nd_kernels_scalar;
extern const nd_draw_table nd_draws_scalar;
#if defined(__x86_64__)
extern const nd_kernel_table nd_kernels_x86_64, nd_kernels_v3, nd_kernels_v4;
extern const nd_draw_table nd_draws_x86_64, nd_draws_v3, nd_draws_v4;

/* The levels of the x86-64 psABI, by the features that compilers use of them. */
static bool has_v3(void) {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}

static bool has_v4(void) {
    return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#elif defined(__aarch64__)
extern const nd_kernel_table nd_kernels_neon;
extern const nd_draw_table nd_draws_neon;
#endif

/* From the plainest to the widest: the last one that runs is the best. */
static const struct {
    const char *name;
    const nd_kernel_table *table;
    const nd_draw_table *draws;
    bool (*runs)(void);
} TABLES[] = {
    {"scalar", &nd_kernels_scalar, &nd_draws_scalar, always},
#if defined(__x86_64__)
    {"x86-64", &nd_kernels_x86_64, &nd_draws_x86_64, always},
    {"x86-64-v3", &nd_kernels_v3, &nd_draws_v3, has_v3},
    {"x86-64-v4", &nd_kernels_v4, &nd_draws_v4, has_v4},
#elif defined(__aarch64__)
    {"neon", &nd_kernels_neon, &nd_draws_neon, always},
#endif
};
enum { COUNT = sizeof TABLES / sizeof *TABLES };

static int best(void) {
    int at = COUNT - 1;
    while (at > 0 && !TABLES[at].runs()) at--;
    return at;
}

/* 0: not chosen yet; else the index in TABLES + 1. The library's only variable. */
static atomic_int chosen;

static int present(void) {
    int at = atomic_load_explicit(&chosen, memory_order_relaxed);
    if (at) return at - 1;
    at = best();
    int none = 0;
    /* Threads that come here at once find the same answer. */
    if (!atomic_compare_exchange_strong(&chosen, &none, at + 1)) at = none - 1;
    return at;
}

const nd_kernel_table *nd_kernels(void) {
    return TABLES[present()].table;
}

const nd_draw_table *nd_draws(void) {
    return TABLES[present()].draws;
}

const char *ndl_isa(void) {
    return TABLES[present()].name;
}

int ndl_use_isa(const char *name) {
    int at = -1;
    if (!name || !*name) at = best();
    for (int i = 0; i < COUNT && at < 0; i++)
        if (strcmp(TABLES[i].name, name) == 0 && TABLES[i].runs()) at = i;
    if (at < 0) return NDL_E_UNKNOWN_NAME;
    atomic_store(&chosen, at + 1);
    return NDL_OK;
}

const char *ndl_version(void) {
#define VERSION3(a, b, c) #a "." #b "." #c
#define VERSION(a, b, c) VERSION3(a, b, c)
    return VERSION(NDL_VERSION_MAJOR, NDL_VERSION_MINOR, NDL_VERSION_PATCH);
}
