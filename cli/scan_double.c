/* SPDX-License-Identifier: Apache-2.0 */
/* Decimal text to double. With at most 19 significant digits the digits are an integer w < 2^64 and
   the value is w 10^e. For |e| <= 27 the power 5^|e| fits in 64 bits, so product and quotient are
   exact in 128 bits (plus a sticky bit) and one rounding remains. */
#include "number_text.h"

#include "base/number.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { MOST_DIGITS = 19, MOST_POWER = 27 };

/* sign, digits w (w = 0 for zero), power of ten. */
typedef struct {
    uint64_t w;
    int e10;
    bool negative;
} decimal;

static bool is_digit(char c) {
    return (unsigned char)(c - '0') < 10;
}

static const char *skip_zeros(const char *p, const char *end) {
    while (p < end && *p == '0') p++;
    return p;
}

static const char *digits(const char *p, const char *end, uint64_t *w) {
    uint64_t value = *w;
    for (; p < end && is_digit(*p); p++) value = 10 * value + (uint64_t)(*p - '0');
    *w = value;
    return p;
}

/* The exponent behind the digits, at most 4 digits of it; NULL when it is longer. */
static const char *exponent(const char *p, const char *end, int *e10) {
    if (p == end || (*p != 'e' && *p != 'E')) return p;
    const char *at = p + 1;
    bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+')) at++;
    if (at == end || !is_digit(*at)) return p;
    uint64_t value = 0;
    const char *last = digits(at, end, &value);
    if (last - at > 4) return NULL;
    *e10 += negative ? -(int)value : (int)value;
    return last;
}

/* Takes a number apart; NULL when it has too many digits or is none. */
static const char *take_apart(const char *s, const char *end, decimal *d) {
    const char *p = s;
    d->negative = p < end && *p == '-';
    if (p < end && (*p == '-' || *p == '+')) p++;
    const char *start = p;
    const char *first = skip_zeros(p, end);
    d->w = 0;
    d->e10 = 0;
    p = digits(first, end, &d->w);
    ptrdiff_t significant = p - first, all = p - start;
    if (p < end && *p == '.') {
        const char *point = p + 1;
        const char *from = significant ? point : skip_zeros(point, end);
        p = digits(from, end, &d->w);
        significant += p - from;
        all += p - point;
        if (p - point > 10000) return NULL;
        d->e10 = -(int)(p - point);
    }
    if (!all || significant > MOST_DIGITS) return NULL;
    return exponent(p, end, &d->e10);
}

/* Clinger's case: integer and power are exact doubles, so one operation rounds correctly. */
static bool small(const decimal *d, double *x) {
    static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (d->w >> 53 || d->e10 > 22 || d->e10 < -22) return false;
    double m = (double)d->w;
    *x = d->e10 < 0 ? m / power[-d->e10] : m * power[d->e10];
    return true;
}

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 wide;

static const uint64_t five[MOST_POWER + 1] = {
    1u, 5u, 25u, 125u, 625u, 3125u, 15625u, 78125u, 390625u, 1953125u, 9765625u, 48828125u,
    244140625u, 1220703125u, 6103515625u, 30517578125u, 152587890625u, 762939453125u,
    3814697265625u, 19073486328125u, 95367431640625u, 476837158203125u, 2384185791015625u,
    11920928955078125u, 59604644775390625u, 298023223876953125u, 1490116119384765625u,
    7450580596923828125u};

/* q 2^e rounded to nearest even, q >= 2^53; `more`: the exact value is a little above q. The
   result is a normal double. */
static double rounded(uint64_t q, bool more, int e) {
    int drop = 11 - __builtin_clzll(q); /* 53 bits are left */
    uint64_t rest = q & ((1ull << drop) - 1), half = 1ull << (drop - 1);
    q >>= drop;
    q += rest > half || (rest == half && (more || (q & 1)));
    /* The leading bit of q counts as one more in the exponent, so does a carry into 2^53. */
    uint64_t bits = ((uint64_t)(e + drop + 52 + 1022) << 52) + q;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static double times_power(uint64_t w, int e10) {
    wide product = (wide)w * five[e10];
    uint64_t high = (uint64_t)(product >> 64);
    int zeros = high ? __builtin_clzll(high) : 64 + __builtin_clzll((uint64_t)product);
    product <<= zeros;
    return rounded((uint64_t)(product >> 64), (uint64_t)product != 0, e10 + 64 - zeros);
}

/* Dividend in [2^126, 2^127), divisor in [2^63, 2^64): the quotient has 63 or 64 bits. */
static double over_power(uint64_t w, int e10) {
    int up = __builtin_clzll(w), up_five = __builtin_clzll(five[e10]);
    uint64_t divisor = five[e10] << up_five;
    wide dividend = (wide)(w << up) << 63;
    uint64_t q = (uint64_t)(dividend / divisor);
    return rounded(q, dividend != (wide)q * divisor, up_five - up - 63 - e10);
}

static bool wide_enough(const decimal *d, double *x) {
    if (d->e10 > MOST_POWER || d->e10 < -MOST_POWER) return false;
    *x = d->e10 < 0 ? over_power(d->w, -d->e10) : times_power(d->w, d->e10);
    return true;
}
#else
static bool wide_enough(const decimal *d, double *x) {
    (void)d, (void)x;
    return false;
}
#endif

size_t cli_scan_double(const char *s, const char *end, double *x) {
    decimal d;
    const char *last = take_apart(s, end, &d);
    double value = 0.0;
    if (!last || (d.w && !small(&d, &value) && !wide_enough(&d, &value)))
        return nd_parse_double(s, (size_t)(end - s), x);
    *x = d.negative ? -value : value;
    return (size_t)(last - s);
}
