/* SPDX-License-Identifier: Apache-2.0 */
/* Decimal conversion. Most numbers take Clinger's exact fast path (at most 2^53 as integer, at most
   10^22 as power); what is left is divided out with big integers, so the result is always the
   nearest value, ties to even. */
#include "base/number.h"

#include "base/bignum.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* A tie between two doubles has at most 767 significant digits; later ones only break it. */
enum { MOST_DIGITS = 770 };

typedef struct {
    char digit[MOST_DIGITS + 1];
    int n;        /* significant digits kept */
    int exponent; /* value = 0.digits... read as an integer, times 10^exponent */
    bool negative;
} decimal;

typedef struct { int mantissa_bits, least_exponent, largest_exponent; } format;
static const format FLOAT = {24, -149, 127}, DOUBLE = {53, -1074, 1023};

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

static void take_digit(decimal *d, char c, bool in_fraction) {
    if (d->n == 0 && c == '0') {
        d->exponent -= in_fraction;
    } else if (d->n < MOST_DIGITS) {
        d->digit[d->n++] = c;
        d->exponent -= in_fraction;
    } else {
        d->exponent += !in_fraction;
        if (c != '0') d->digit[MOST_DIGITS - 1] = '1'; /* sticky: never an exact tie any more */
    }
}

static size_t read_exponent(const char *s, size_t n, size_t at, int *exponent) {
    size_t start = at;
    if (at >= n || (s[at] != 'e' && s[at] != 'E')) return start;
    at++;
    bool negative = at < n && s[at] == '-';
    if (at < n && (s[at] == '-' || s[at] == '+')) at++;
    if (at >= n || !is_digit(s[at])) return start;
    int value = 0;
    for (; at < n && is_digit(s[at]); at++)
        if (value < 100000) value = 10 * value + (s[at] - '0');
    *exponent += negative ? -value : value;
    return at;
}

static size_t read_decimal(const char *s, size_t n, decimal *d) {
    size_t at = 0;
    bool any = false;
    d->n = d->exponent = 0;
    d->negative = n && s[0] == '-';
    if (n && (s[0] == '-' || s[0] == '+')) at++;
    for (; at < n && is_digit(s[at]); at++, any = true) take_digit(d, s[at], false);
    if (at < n && s[at] == '.') {
        size_t dot = at++;
        for (; at < n && is_digit(s[at]); at++, any = true) take_digit(d, s[at], true);
        if (!any) at = dot;
    }
    return any ? read_exponent(s, n, at, &d->exponent) : 0;
}

/* e with 2^(e-1) <= top / bottom < 2^e. */
static int binary_exponent(const nd_big *top, const nd_big *bottom) {
    int e = nd_big_bits(top) - nd_big_bits(bottom);
    nd_big aligned = e < 0 ? *top : *bottom;
    nd_big_shift(&aligned, e < 0 ? -e : e);
    int order = e < 0 ? nd_big_compare(&aligned, bottom) : nd_big_compare(top, &aligned);
    return order >= 0 ? e + 1 : e;
}

/* The exact quotient of two integers, rounded to f; as a double, which holds every float. */
static double round_quotient(nd_big *top, nd_big *bottom, const format *f) {
    int exponent = binary_exponent(top, bottom);
    int last = exponent - f->mantissa_bits; /* weight of the last kept bit */
    if (last < f->least_exponent) last = f->least_exponent;
    if (last < 0) nd_big_shift(top, -last);
    else nd_big_shift(bottom, last);
    uint64_t q = 0; /* top / bottom by long division in base 2 */
    int steps = nd_big_bits(top) - nd_big_bits(bottom);
    if (steps < 0) steps = 0;
    nd_big_shift(bottom, steps);
    for (int i = 0; i <= steps; i++) {
        q <<= 1;
        if (nd_big_compare(top, bottom) >= 0) {
            nd_big_subtract(top, bottom);
            q |= 1;
        }
        nd_big_shift(top, 1);
    }
    /* top now holds twice the remainder, in units of the shifted divisor */
    int half = nd_big_compare(top, bottom);
    q += half > 0 || (half == 0 && (q & 1));
    double value = ldexp((double)q, last);
    return value >= ldexp(1.0, f->largest_exponent + 1) ? (double)INFINITY : value;
}

static double exact(const decimal *d, const format *f) {
    if (d->n + d->exponent > 400) return (double)INFINITY;
    if (d->n + d->exponent < -400) return 0.0;
    nd_big top, bottom;
    nd_big_set(&top, 0);
    nd_big_set(&bottom, 1);
    for (int i = 0; i < d->n; i++) {
        uint32_t digit = (uint32_t)(d->digit[i] - '0');
        if (top.n) nd_big_multiply_add(&top, 10, digit);
        else nd_big_set(&top, digit);
    }
    if (d->exponent >= 0) nd_big_power_of_ten(&top, d->exponent);
    else nd_big_power_of_ten(&bottom, -d->exponent);
    return round_quotient(&top, &bottom, f);
}

/* Exact where integer and power both are: one correctly rounded operation remains. */
static bool fast(const decimal *d, double *x) {
    static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (d->n > 15 || d->exponent > 22 || d->exponent < -22) return false;
    int64_t integer = 0;
    for (int i = 0; i < d->n; i++) integer = 10 * integer + (d->digit[i] - '0');
    double m = (double)integer;
    *x = d->exponent < 0 ? m / power[-d->exponent] : m * power[d->exponent];
    return true;
}

size_t nd_parse_double(const char *s, size_t n, double *x) {
    decimal d;
    size_t used = read_decimal(s, n, &d);
    if (!used) return 0;
    double value = 0.0;
    if (d.n && !fast(&d, &value)) value = exact(&d, &DOUBLE);
    *x = d.negative ? -value : value;
    return used;
}

size_t nd_parse_float(const char *s, size_t n, float *x) {
    decimal d;
    size_t used = read_decimal(s, n, &d);
    if (!used) return 0;
    double value = 0.0;
    if (d.n) {
        bool near_tie = true;
        if (fast(&d, &value) && value >= 0x1p-126 && value < 0x1p127) {
            uint64_t bits;
            memcpy(&bits, &value, sizeof bits);
            /* A double may have been rounded onto the middle between two floats. */
            near_tie = (bits & 0x1fffffff) == 0x10000000;
        }
        if (near_tie) value = exact(&d, &FLOAT);
    }
    *x = (float)(d.negative ? -value : value);
    return used;
}

enum { FULL = 9 }; /* digits that tell any two floats apart */

/* The first FULL + 1 decimal digits of x > 0, cut; returns the exponent of the first one. */
static int leading_digits(float x, char digit[FULL + 2], bool *more) {
    int e2, e10 = 0;
    uint32_t m = (uint32_t)ldexp(frexp((double)x, &e2), 24);
    nd_big top, bottom;
    nd_big_set(&top, m);
    nd_big_set(&bottom, 1);
    if (e2 >= 24) nd_big_shift(&top, e2 - 24);
    else nd_big_shift(&bottom, 24 - e2);
    while (nd_big_compare(&top, &bottom) < 0) {
        nd_big_multiply_add(&top, 10, 0);
        e10--;
    }
    for (;;) {
        nd_big ten = bottom;
        nd_big_multiply_add(&ten, 10, 0);
        if (nd_big_compare(&top, &ten) < 0) break;
        bottom = ten;
        e10++;
    }
    for (int i = 0; i <= FULL; i++) {
        digit[i] = '0';
        for (; nd_big_compare(&top, &bottom) >= 0; digit[i]++) nd_big_subtract(&top, &bottom);
        nd_big_multiply_add(&top, 10, 0);
    }
    digit[FULL + 1] = '\0';
    *more = top.n != 0;
    return e10;
}

/* digits[0..keep) rounded half up from the full string; a carry may add one to the exponent. */
static int round_digits(const char *full, int keep, char *to) {
    memcpy(to, full, (size_t)keep);
    to[keep] = '\0';
    if (full[keep] < '5') return 0;
    for (int i = keep - 1; i >= 0; i--) {
        if (to[i] != '9') {
            to[i]++;
            return 0;
        }
        to[i] = '0';
    }
    to[0] = '1';
    return 1;
}

static size_t put_exponent(char *to, int e10) {
    size_t n = 0;
    to[n++] = 'e';
    if (e10 < 0) to[n++] = '-';
    int e = e10 < 0 ? -e10 : e10;
    if (e >= 10) to[n++] = (char)('0' + e / 10);
    to[n++] = (char)('0' + e % 10);
    return n;
}

static size_t layout(const char *digits, int count, int e10, char *to) {
    size_t n = 0;
    if (e10 < -5 || e10 >= FULL) {
        to[n++] = digits[0];
        if (count > 1) to[n++] = '.';
        for (int i = 1; i < count; i++) to[n++] = digits[i];
        n += put_exponent(to + n, e10);
    } else if (e10 < 0) {
        to[n++] = '0';
        to[n++] = '.';
        for (int i = -1; i > e10; i--) to[n++] = '0';
        for (int i = 0; i < count; i++) to[n++] = digits[i];
    } else {
        for (int i = 0; i < count || i <= e10; i++) {
            if (i == e10 + 1) to[n++] = '.';
            to[n++] = i < count ? digits[i] : '0';
        }
    }
    return n;
}

size_t nd_format_float(float x, char to[ND_NUMBER_ROOM]) {
    size_t n = 0;
    if (signbit(x)) to[n++] = '-';
    float magnitude = fabsf(x);
    if (isnan(x)) return (size_t)(strcpy(to, "nan") - to) + 3;
    if (isinf(x)) return (size_t)(strcpy(to + n, "inf") - to) + 3;
    if (magnitude == 0.0f) return (size_t)(strcpy(to + n, "0") - to) + 1;
    char full[FULL + 2], digits[FULL + 1];
    bool more;
    int e10 = leading_digits(magnitude, full, &more);
    for (int keep = 1; keep <= FULL; keep++) {
        int carry = round_digits(full, keep, digits);
        int count = keep;
        while (count > 1 && digits[count - 1] == '0') count--;
        size_t end = n + layout(digits, count, e10 + carry, to + n);
        to[end] = '\0';
        float back;
        if (nd_parse_float(to + n, end - n, &back) && back == magnitude) return end;
    }
    return strlen(to);
}
