/* SPDX-License-Identifier: Apache-2.0 */
/* The readers of `ndotl eval`: lines of numbers and .npy arrays. Numbers are those of the slow
   parser, what is accepted becomes unit vectors, what is refused is named. */
#include "base/number.h"
#include "directions.h"
#include "npy.h"
#include "number_text.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void require(bool condition) {
    if (!condition) abort();
}

static void check_unit(float x, float y, float z) {
    double square = (double)x * (double)x + (double)y * (double)y + (double)z * (double)z;
    require(fabs(square - 1.0) < 1e-6);
}

static cli_pairs pairs;

static void check_pair(const double *v, bool angles) {
    double off = 1.0;
    pairs.n = 0;
    const char *wrong = cli_pairs_add(&pairs, v, angles, &off);
    require(wrong ? pairs.n == 0 : pairs.n == 1);
    if (wrong) return;
    require(off > 0.0);
    check_unit(pairs.ix[0], pairs.iy[0], pairs.iz[0]);
    check_unit(pairs.ox[0], pairs.oy[0], pairs.oz[0]);
}

static void check_line(const char *s, const char *end) {
    double v[6] = {0};
    const char *what = NULL, *at = NULL;
    size_t n = 0;
    int found = cli_line_numbers(s, end, v, 6, &what, &at, &n);
    if (found < 0) {
        require(what && at >= s && at < end && n > 0 && n <= (size_t)(end - at));
        return;
    }
    for (int i = 0; i < found && i < 6; i++)
        require(isfinite(v[i]));
    if (found == 6) check_pair(v, false);
    if (found == 4) check_pair(v, true);
}

static void check_number(const char *s, size_t n) {
    double quick = 0.0, slow = 0.0;
    size_t used = cli_scan_double(s, s + n, &quick);
    require(used == nd_parse_double(s, n, &slow));
    require(memcmp(&quick, &slow, sizeof slow) == 0);
}

static void check_npy(const char *s, size_t n) {
    cli_npy a;
    if (!cli_npy_begins(s, n) || cli_npy_view(s, n, 6, &a)) return;
    volatile double sum = 0.0;
    for (size_t i = 0; i < a.rows; i++)
        for (size_t k = 0; k < a.columns; k++)
            sum = sum + cli_npy_value(&a, i, k);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *s = (const char *)data, *end = s + size;
    check_number(s, size);
    check_npy(s, size);
    while (s < end) {
        const char *line = memchr(s, '\n', (size_t)(end - s));
        check_line(s, line ? line : end);
        s = line ? line + 1 : end;
    }
    return 0;
}
