/* SPDX-License-Identifier: Apache-2.0 */
/* Numbers to and from decimal text: correctly rounded, without a locale. */
#ifndef ND_BASE_NUMBER_H
#define ND_BASE_NUMBER_H
#include <stddef.h>

enum { ND_NUMBER_ROOM = 24 }; /* bytes that any formatted float needs, terminator included */

/* Reads a decimal number with optional sign, fraction and exponent from the first n bytes of s,
   rounded to nearest even; beyond the largest finite value it is an infinity. Returns the bytes
   read; 0 where no number begins. */
size_t nd_parse_float(const char *s, size_t n, float *x);
size_t nd_parse_double(const char *s, size_t n, double *x);

/* Writes the shortest decimal that reads back as the same float, terminated; returns its length.
   Infinities and NaN become "inf", "-inf", "nan". */
size_t nd_format_float(float x, char to[ND_NUMBER_ROOM]);

#endif
