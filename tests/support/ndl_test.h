/* SPDX-License-Identifier: Apache-2.0 */
/* cmocka and the comparisons that it lacks. A failed comparison prints both values in full. */
#ifndef NDL_TEST_H
#define NDL_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Steps between two floats on the line of all floats (-0 and +0 are one point); a huge number when
   exactly one is NaN. */
static inline uint32_t ulp_distance(float a, float b) {
    int32_t i, j;
    if (isnan(a) || isnan(b)) {
        return isnan(a) && isnan(b) ? 0 : UINT32_MAX;
    }
    memcpy(&i, &a, sizeof i);
    memcpy(&j, &b, sizeof j);
    int64_t p = i < 0 ? (int64_t)INT32_MIN - i : i;
    int64_t q = j < 0 ? (int64_t)INT32_MIN - j : j;
    return (uint32_t)(p > q ? p - q : q - p);
}

static inline void ulp_check(float got, float want, uint32_t most, const char *text,
                             const char *file, int line) {
    uint32_t distance = ulp_distance(got, want);
    if (distance > most) {
        print_error("%s = %.9g (%a), want %.9g (%a): %lu ulp apart, at most %lu\n", text,
                    (double)got, (double)got, (double)want, (double)want, (unsigned long)distance,
                    (unsigned long)most);
        _fail(file, line);
    }
}

/* |got - want| <= relative * |want| + absolute; never true of NaN. */
static inline int is_close(double got, double want, double relative, double absolute) {
    return got == want || fabs(got - want) <= relative * fabs(want) + absolute;
}

static inline void close_check(double got, double want, double relative, double absolute,
                               const char *text, const char *file, int line) {
    if (!is_close(got, want, relative, absolute)) {
        print_error("%s = %.17g, want %.17g: off by %.3g, relative %.3g, allowed %.3g + %.3g\n",
                    text, got, want, got - want, (got - want) / want, relative, absolute);
        _fail(file, line);
    }
}

/* got is within `most` float steps of want; both are floats. */
#define assert_ulp(got, want, most) ulp_check((got), (want), (most), #got, __FILE__, __LINE__)

/* The same float, bit for bit but for the sign of zero. */
#define assert_same_float(got, want) assert_ulp(got, want, 0)

#define assert_relative(got, want, relative)                                                      \
    close_check((double)(got), (double)(want), (relative), 0.0, #got, __FILE__, __LINE__)

#define assert_absolute(got, want, absolute)                                                      \
    close_check((double)(got), (double)(want), 0.0, (absolute), #got, __FILE__, __LINE__)

#define assert_close(got, want, relative, absolute)                                               \
    close_check((double)(got), (double)(want), (relative), (absolute), #got, __FILE__, __LINE__)

/* Ends the program as skipped, with the reason; call it in main, before any test has run. */
static inline void skip_program(const char *reason) {
    printf("skipped: %s\n", reason);
    exit(77);
}

/* The folder of real input (meshes, spectra); without it the program is skipped. */
static inline const char *need_test_data(void) {
    const char *folder = getenv("NDOTL_TEST_DATA");
    if (!folder || !*folder) {
        skip_program("NDOTL_TEST_DATA is not set");
    }
    return folder;
}

#endif
