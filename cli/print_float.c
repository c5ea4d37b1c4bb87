/* SPDX-License-Identifier: Apache-2.0 */
/* "%.9g" of floats. The float is scaled to nine digits in double: off by a few 2^-53 relative, that
   is less than 1e-6 of the last digit. Unless the rest is that near to a half, its rounding is
   certain; the others (about one in 10000, and exact halves) go to snprintf. */
#include "number_text.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS = 9 };

static const double power[] = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13,
    1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22, 1e23, 1e24, 1e25, 1e26, 1e27,
    1e28, 1e29, 1e30, 1e31, 1e32, 1e33, 1e34, 1e35, 1e36, 1e37, 1e38, 1e39, 1e40, 1e41,
    1e42, 1e43, 1e44, 1e45, 1e46, 1e47, 1e48, 1e49, 1e50, 1e51, 1e52, 1e53};

static double scaled(double v, int e10) {
    int k = DIGITS - 1 - e10;
    return k < 0 ? v / power[-k] : v * power[k];
}

/* Nine digits of v > 0 as an integer in [1e8, 1e9) and the exponent of the first one; 0 when the
   rounding is not certain. */
static uint32_t nine_digits(double v, int *exponent) {
    uint64_t bits;
    memcpy(&bits, &v, sizeof bits);
    int e2 = (int)(bits >> 52) - 1023;
    int e10 = e2 * 315653 >> 20; /* floor(e2 log10(2)): the exponent, or one less */
    double s = scaled(v, e10);
    if (s >= 1e9) s = scaled(v, ++e10);
    uint32_t n = (uint32_t)s;
    double rest = s - (double)n;
    if (fabs(rest - 0.5) < 1e-4) return 0;
    n += rest > 0.5;
    if (n == 1000000000u) {
        n = 100000000u;
        e10++;
    }
    *exponent = e10;
    return n;
}

static void put_digits(uint32_t n, char to[DIGITS]) {
    static const char pairs[] = "0001020304050607080910111213141516171819"
                                "2021222324252627282930313233343536373839"
                                "4041424344454647484950515253545556575859"
                                "6061626364656667686970717273747576777879"
                                "8081828384858687888990919293949596979899";
    for (int i = DIGITS - 2; i > 0; i -= 2) {
        memcpy(to + i, pairs + 2 * (n % 100), 2);
        n /= 100;
    }
    to[0] = (char)('0' + n);
}

static char *put_scientific(char *to, const char *digit, int count, int e10) {
    *to++ = digit[0];
    if (count > 1) {
        *to++ = '.';
        memcpy(to, digit + 1, (size_t)count - 1);
        to += count - 1;
    }
    *to++ = 'e';
    *to++ = e10 < 0 ? '-' : '+';
    int e = e10 < 0 ? -e10 : e10;
    *to++ = (char)('0' + e / 10);
    *to++ = (char)('0' + e % 10);
    return to;
}

static char *put_fixed(char *to, const char *digit, int count, int e10) {
    if (e10 < 0) {
        memcpy(to, "0.000", 5);
        to += 1 - e10;
        memcpy(to, digit, DIGITS);
        return to + count;
    }
    int whole = e10 + 1;
    memcpy(to, digit, DIGITS);
    if (count <= whole) return to + whole;
    to[whole] = '.';
    memcpy(to + whole + 1, digit + whole, (size_t)(count - whole));
    return to + count + 1;
}

size_t cli_print_float(float x, char *to) {
    char digit[DIGITS];
    char *at = to;
    int e10;
    if (signbit(x)) *at++ = '-';
    if (x == 0.0f) {
        *at++ = '0';
        return (size_t)(at - to);
    }
    uint32_t n = isfinite(x) ? nine_digits(fabs((double)x), &e10) : 0;
    if (!n) return (size_t)snprintf(to, CLI_PRINT_ROOM, "%.9g", (double)x);
    put_digits(n, digit);
    int count = DIGITS;
    while (digit[count - 1] == '0') count--;
    if (e10 < -4 || e10 >= DIGITS) at = put_scientific(at, digit, count, e10);
    else at = put_fixed(at, digit, count, e10);
    return (size_t)(at - to);
}
