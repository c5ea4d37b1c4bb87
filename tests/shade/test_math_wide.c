/* SPDX-License-Identifier: Apache-2.0 */
/* The same text in double, the wide reference of other tests: good to 1e-14. */
#define ND_WIDE
#include "reference.h"

#define ROW(f, relative, absolute)                                                                 \
    { #f, call_##f, NULL, relative, absolute }
static const reference_row rows[] = {
    ROW(exp, 4, 0),
    ROW(expm1, 4, 0),
    ROW(log, 4, 0),
    ROW(log1p, 4, 0),
    ROW(acos, 4, 0),
    ROW(sin, 0, 1),
    ROW(cos, 0, 1),
    ROW(sin2pi, 4, 3),
    ROW(cos2pi, 4, 3),
    ROW(erf, 4, 0),
    ROW(erfc, 4, 0),
    ROW(erfinv, 8, 0),
    {"pow", NULL, call_pow, 4, 0},
    {"atan2", NULL, call_atan2, 4, 0},
};

static void wide_functions_agree_with_mpmath(void **state) {
    (void)state;
    check_reference(rows, sizeof rows / sizeof *rows, 0x1p-52);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(wide_functions_agree_with_mpmath)};
    return cmocka_run_group_tests_name("math_wide", tests, NULL, NULL);
}
