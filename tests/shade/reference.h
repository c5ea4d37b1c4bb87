/* SPDX-License-Identifier: Apache-2.0 */
/* src/shade/math.h, as the including file compiles it (float, or double with ND_WIDE), against
   math_reference.csv. */
#ifndef NDL_TEST_REFERENCE_H
#define NDL_TEST_REFERENCE_H

#include "ndl_test.h"
#include "shade/math.h"

typedef struct {
    const char *name;
    num (*one)(num);
    num (*two)(num, num);
    double relative, absolute; /* in units of the build's precision */
} reference_row;

#define ONE(f)                                                                                     \
    static num call_##f(num x) {                                                                   \
        return f##_(x);                                                                            \
    }
#define TWO(f)                                                                                     \
    static num call_##f(num x, num y) {                                                            \
        return f##_(x, y);                                                                         \
    }
ONE(exp)
ONE(expm1)
ONE(log)
ONE(log1p)
ONE(acos)
ONE(sin)
ONE(cos)
ONE(sin2pi)
ONE(cos2pi)
ONE(erf)
ONE(erfc)
ONE(erfinv)
TWO(pow)
TWO(atan2)
#undef ONE
#undef TWO

/* Fails where |got - value| > precision (relative |value| + absolute). */
static void check_reference(const reference_row *rows, size_t count, double precision) {
    char path[1024], line[256], name[16];
    const char *source = getenv("NDOTL_SOURCE");
    snprintf(path, sizeof path, "%s/tests/shade/math_reference.csv", source ? source : ".");
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    size_t seen = 0;
    double worst = 0;
    while (fgets(line, sizeof line, f)) {
        double x, y, value;
        if (sscanf(line, "%15[a-z0-9],%lf,%lf,%lf", name, &x, &y, &value) != 4) {
            continue;
        }
        const reference_row *row = rows;
        while (row < rows + count && strcmp(row->name, name) != 0) {
            row++;
        }
        assert_true(row < rows + count);
        num got = row->one ? row->one((num)x) : row->two((num)x, (num)y);
        double k = row->two == call_pow && x > 0 ? 2 * fabs(y * log(x)) : 0;
        double allowed = precision * ((row->relative + k) * fabs(value) + row->absolute);
        if (!(fabs((double)got - value) <= allowed)) {
            fail_msg("%s(%.9g, %.9g) = %.17g, want %.17g, off by %.3g, allowed %.3g", name, x, y,
                     (double)got, value, (double)got - value, allowed);
        }
        worst = fmax(worst, allowed > 0 ? fabs((double)got - value) / allowed : 0);
        seen++;
    }
    fclose(f);
    print_message("%lu values, at most %.2f of what is allowed\n", (unsigned long)seen, worst);
    assert_true(seen > 5000);
}

#endif
