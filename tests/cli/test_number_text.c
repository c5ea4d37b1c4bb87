/* SPDX-License-Identifier: Apache-2.0 */
/* The quick number text gives what the slow ways give: printf, and nd_parse_double. */
#include "ndl_test.h"

#include "base/number.h"
#include "number_text.h"

enum { ROUNDS = 300000 };

static uint64_t state = 88172645463325252u;
static uint64_t draw(void) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static void check_print(float x) {
    char got[CLI_PRINT_ROOM + 1], wanted[64];
    size_t n = cli_print_float(x, got);
    assert_true(n <= CLI_PRINT_ROOM);
    got[n] = '\0';
    snprintf(wanted, sizeof wanted, "%.9g", (double)x);
    assert_string_equal(got, wanted);
}

static float of_bits(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static void printing_equals_printf(void **unused) {
    (void)unused;
    for (int i = 0; i < ROUNDS; i++) {
        float any = of_bits((uint32_t)draw());
        if (!isnan(any)) check_print(any);
        check_print((float)(draw() % 100000) / (float)(1u << draw() % 24));
    }
    for (uint32_t bits = 0; bits < 3000; bits++)
        check_print(of_bits(bits)); /* subnormals */
    for (float x = 1e-44f; x < 1e38f; x *= 10.0f) {
        check_print(x);
        check_print(nextafterf(x, 0.0f));
        check_print(nextafterf(x, INFINITY));
        check_print(5.0f * x);
    }
    check_print(INFINITY);
    check_print(-INFINITY);
    check_print(-0.0f);
    check_print(3.40282347e38f);
}

static void check_scan(const char *s, size_t n) {
    double got = 7.0, wanted = 7.0;
    size_t used = cli_scan_double(s, s + n, &got);
    if (used != nd_parse_double(s, n, &wanted) || memcmp(&got, &wanted, sizeof got) != 0)
        fail_msg("'%.*s': %.17g, wanted %.17g", (int)n, s, got, wanted);
}

static void scanning_equals_the_slow_parser(void **unused) {
    (void)unused;
    static const char *const formats[] = {"%.17g", "%.9g",  "%.6f", "%.18e",
                                          "%.3g",  "%.16f", "%.15e"};
    for (int i = 0; i < ROUNDS / 4; i++) {
        char s[512];
        double x = ldexp((double)(int64_t)draw(), (int)(draw() % 200) - 160);
        int n =
            snprintf(s, sizeof s, formats[draw() % 7], i % 2 ? x : (double)(int64_t)draw() / 1e19);
        check_scan(s, (size_t)n);
    }
}

static void scanning_odd_text_equals_the_slow_parser(void **unused) {
    (void)unused;
    static const char alphabet[] = "0123456789.+-eE 0009,";
    for (int i = 0; i < ROUNDS; i++) {
        char s[16];
        size_t n = draw() % sizeof s;
        for (size_t k = 0; k < n; k++)
            s[k] = alphabet[draw() % (sizeof alphabet - 1)];
        check_scan(s, n);
    }
}

/* Halfway between two doubles, and a little to either side. */
static void ties_round_to_even(void **unused) {
    (void)unused;
    static const char *const ties[] = {"9007199254740993",
                                       "9007199254740995",
                                       "9007199254740993.0000001",
                                       "18014398509481986",
                                       "18014398509481990",
                                       "4503599627370496.5",
                                       "4503599627370497.5",
                                       "1e23",
                                       "8.5e22",
                                       "9007199254740992.5",
                                       "1.00000000000000011102230246251565",
                                       "0.000000000000000000000000001",
                                       "1234567890123456789e27",
                                       "9999999999999999999e-27",
                                       "18446744073709551615",
                                       "18446744073709551616",
                                       "0.1e-400",
                                       "1e400",
                                       "4.9e-324",
                                       "1e00000000000000000001"};
    for (size_t i = 0; i < sizeof ties / sizeof *ties; i++)
        check_scan(ties[i], strlen(ties[i]));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(printing_equals_printf),
        cmocka_unit_test(scanning_equals_the_slow_parser),
        cmocka_unit_test(scanning_odd_text_equals_the_slow_parser),
        cmocka_unit_test(ties_round_to_even),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
