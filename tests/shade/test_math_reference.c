/* SPDX-License-Identifier: Apache-2.0 */
/* The float functions against values that owe nothing to libm. */
#include "reference.h"

#define ROW(f, relative, absolute)                                                                 \
    { #f, call_##f, NULL, relative, absolute }
static const reference_row rows[] = {
    ROW(exp, 1.1, 0),
    ROW(expm1, 2, 0),
    ROW(log, 1, 0),
    ROW(log1p, 3, 0),
    ROW(acos, 2, 0),
    ROW(sin, 0, 1),
    ROW(cos, 0, 1),
    ROW(sin2pi, 2, 0),
    ROW(cos2pi, 2, 0),
    ROW(erf, 2, 0),
    ROW(erfc, 70, 0),
    ROW(erfinv, 4, 0),
    {"pow", NULL, call_pow, 1, 0},
    {"atan2", NULL, call_atan2, 3, 0},
};

static void float_functions_agree_with_mpmath(void **state) {
    (void)state;
    check_reference(rows, sizeof rows / sizeof *rows, 0x1p-23);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(float_functions_agree_with_mpmath)};
    return cmocka_run_group_tests_name("math_reference", tests, NULL, NULL);
}
