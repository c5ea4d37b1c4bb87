/* SPDX-License-Identifier: Apache-2.0 */
/* Numbers as text against strtod and strtof, which are correctly rounded in the C libraries that
   the tests run with: random bits, values half way between two floats, subnormals, the ends of the
   range. Written numbers read back to the same bits and no shorter text does. */
#include "ndl_test.h"

#include "base/number.h"

static uint64_t seed = 88172645463325252ULL;
static uint64_t bits64(void) {
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return seed;
}

static float any_float(void) {
    uint32_t u = (uint32_t)bits64();
    if (bits64() % 4 == 0) u &= 0x80ffffff; /* many subnormals */
    float x;
    memcpy(&x, &u, sizeof x);
    return isfinite(x) ? x : 1.0f;
}

static double any_double(void) {
    uint64_t u = bits64();
    if (bits64() % 4 == 0) u &= 0x801fffffffffffffULL;
    double x;
    memcpy(&x, &u, sizeof x);
    return isfinite(x) ? x : 1.0;
}

static void read_like_strtod(const char *text) {
    float f = -1.0f, want_f = strtof(text, NULL);
    double d = -1.0, want_d = strtod(text, NULL);
    size_t n = strlen(text);
    if (nd_parse_float(text, n, &f) != n || memcmp(&f, &want_f, sizeof f) != 0)
        fail_msg("'%s' as float: %a, want %a", text, (double)f, (double)want_f);
    if (nd_parse_double(text, n, &d) != n || memcmp(&d, &want_d, sizeof d) != 0)
        fail_msg("'%s' as double: %a, want %a", text, d, want_d);
}

static void random_numbers_are_read_exactly(void **state) {
    (void)state;
    char text[128];
    for (int i = 0; i < 40000; i++) {
        snprintf(text, sizeof text, "%.*e", (int)(bits64() % 20), (double)any_float());
        read_like_strtod(text);
        snprintf(text, sizeof text, "%.*e", (int)(bits64() % 25), any_double());
        read_like_strtod(text);
        snprintf(text, sizeof text, "%d.%06de%d", (int)(bits64() % 100000),
                 (int)(bits64() % 1000000), (int)(bits64() % 90) - 50);
        read_like_strtod(text);
    }
}

/* The middle between x and its neighbour, written exactly, and a last digit above and below it. */
static void middles_go_to_the_even_neighbour(void **state) {
    (void)state;
    static char text[1200];
    for (int i = 0; i < 8000; i++) {
        float x = fabsf(any_float());
        double middle = ((double)x + (double)nextafterf(x, INFINITY)) / 2.0;
        int n = snprintf(text, sizeof text, "%.150e", middle); /* 113 digits are exact */
        char *digits = strchr(text, 'e');
        read_like_strtod(text);
        memmove(digits + 1, digits, strlen(digits) + 1);
        *digits = '1'; /* just above */
        assert_int_equal(strlen(text), n + 1);
        read_like_strtod(text);
        /* 15 digits, whose nearest double often is the middle though they are not. */
        snprintf(text, sizeof text, "%.14e", middle);
        read_like_strtod(text);
    }
    for (int i = 0; i < 800; i++) { /* of doubles: long double holds the middle */
        double x = fabs(any_double());
        long double middle = ((long double)x + (long double)nextafter(x, (double)INFINITY)) / 2.0L;
        snprintf(text, sizeof text, "%.800Le", middle);
        read_like_strtod(text);
        char *digits = strchr(text, 'e');
        memmove(digits + 1, digits, strlen(digits) + 1);
        *digits = '1';
        read_like_strtod(text);
    }
}

static void ends_of_the_range(void **state) {
    (void)state;
    static const char *const texts[] = {
        "0", "-0", "+0", "0.0", "1", "-1", "+1", ".5", "5.", "1e0", "1E+2", "1e-2", "00012.500",
        "3.4028234663852886e38", "3.4028235677973366e38",
        "3.40282356779733661637539395458142568447e38",
        "3.40282356779733661637539395458142568448e38", "1e39", "-1e39", "1e400", "1e99999999999",
        "1e-45", "7e-46", "7.006492321624085e-46", "7.006492321624086e-46", "1e-46", "1e-400",
        "1e-99999999999", "0e99999999999", "1.7976931348623157e308", "1.7976931348623159e308",
        "4.9406564584124654e-324", "2.4703282292062327e-324", "2.4703282292062328e-324",
        "9007199254740993", "9007199254740992.5", "16777217", "16777217.0000000000000000000001"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) read_like_strtod(texts[i]);
    static char text[3000]; /* more digits than any tie needs, before and after the point */
    memset(text, '0', sizeof text);
    memcpy(text, "16777217.", 9);
    memcpy(text + 2000, "1", 2);
    read_like_strtod(text);
    memset(text, '0', sizeof text);
    text[0] = '1';
    memcpy(text + 2000, "e-1995", 7);
    read_like_strtod(text);
    memset(text, '0', sizeof text);
    text[1] = '.';
    memcpy(text + 2000, "17e1999", 8);
    read_like_strtod(text);
}

static void only_the_number_is_taken(void **state) {
    (void)state;
    static const struct { const char *text; size_t used; float value; } rows[] = {
        {"", 0, 0}, {".", 0, 0}, {"-", 0, 0}, {"+.e1", 0, 0}, {"e5", 0, 0}, {"inf", 0, 0},
        {"nan", 0, 0}, {" 1", 0, 0}, {"1e", 1, 1}, {"1e+", 1, 1}, {"1e+x", 1, 1},
        {"1.2.3", 3, 1.2f},
        {"0x10", 1, 0}, {"1,5", 1, 1}, {"1.e2x", 4, 100}, {"-.5]", 3, -.5f}, {"1f", 1, 1},
        {"--1", 0, 0}, {"1e2e3", 3, 100}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        float x = 0.0f;
        assert_int_equal(nd_parse_float(rows[i].text, strlen(rows[i].text), &x), rows[i].used);
        assert_same_float(x, rows[i].value);
    }
    float x;
    assert_int_equal(nd_parse_float("12345", 3, &x), 3); /* never past the length */
    assert_same_float(x, 123.0f);
}

static int digits_of(const char *text) {
    int n = 0, zeros = 0, seen = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9') continue;
        seen |= *text != '0';
        if (!seen) continue;
        n++;
        zeros = *text == '0' ? zeros + 1 : 0;
    }
    return n - zeros;
}

static int digits_needed(float x) {
    char text[64];
    for (int n = 1; n < 9; n++) {
        snprintf(text, sizeof text, "%.*e", n - 1, (double)x);
        if (strtof(text, NULL) == x) return n;
    }
    return 9;
}

static void write_and_read(float x) {
    char text[ND_NUMBER_ROOM];
    size_t n = nd_format_float(x, text);
    float back = strtof(text, NULL), ours;
    assert_int_equal(n, strlen(text));
    assert_true(n < ND_NUMBER_ROOM);
    assert_int_equal(nd_parse_float(text, n, &ours), n);
    if (memcmp(&back, &x, sizeof x) != 0 || memcmp(&ours, &x, sizeof x) != 0)
        fail_msg("%a is written as '%s', which is %a", (double)x, text, (double)back);
    if (x != 0.0f && digits_of(text) > digits_needed(x))
        fail_msg("%a is written as '%s', %d digits do", (double)x, text, digits_needed(x));
}

static void floats_are_written_shortest(void **state) {
    (void)state;
    for (int i = 0; i < 60000; i++) write_and_read(any_float());
    for (int e = -149; e < 128; e++) { /* powers of two, where the lower neighbour is nearer */
        float x = (float)ldexp(1.0, e);
        write_and_read(x);
        write_and_read(nextafterf(x, 0.0f));
        write_and_read(-nextafterf(x, INFINITY));
    }
    static const struct { float x; const char *text; } rows[] = {
        {0.0f, "0"}, {-0.0f, "-0"}, {1.0f, "1"}, {0.1f, "0.1"}, {-2.5f, "-2.5"}, {1e-5f, "0.00001"},
        {1e-6f, "1e-6"}, {123456792.0f, "123456790"}, {1e9f, "1e9"}, {1.5e30f, "1.5e30"},
        {3.40282347e38f, "3.4028235e38"}, {1e-45f, "1e-45"}, {0.3f, "0.3"},
        {16777216.0f, "16777216"},
        {INFINITY, "inf"}, {-INFINITY, "-inf"}, {NAN, "nan"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[ND_NUMBER_ROOM];
        assert_int_equal(nd_format_float(rows[i].x, text), strlen(rows[i].text));
        assert_string_equal(text, rows[i].text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_numbers_are_read_exactly),
        cmocka_unit_test(middles_go_to_the_even_neighbour),
        cmocka_unit_test(ends_of_the_range),
        cmocka_unit_test(only_the_number_is_taken),
        cmocka_unit_test(floats_are_written_shortest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
