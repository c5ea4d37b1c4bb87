/* SPDX-License-Identifier: Apache-2.0 OR MIT-0 */
/* What the shading text means in GLSL 4.50 and GLSL ES 3.00: macros only, so that
   `cpp -P -C -undef -nostdinc -imacros prelude_glsl.h` leaves native GLSL. Whoever assembles the
   shader supplies lut1 and lut2; a table is an int there, the number of its constant array. */
#ifndef ND_PRELUDE
#define ND_PRELUDE
#define ND_NATIVE /* exp and log are the target's own */

#define num float
#define cond bool
#define table1 int
#define table2 int
#define FN
#define STRUCT(name) struct name
#define NUM(x) x

#define sel(c, a, b) ((c) ? (a) : (b))
#define both(a, b) ((a) && (b))
#define either(a, b) ((a) || (b))
#define not_(a) (!(a))

#define min_(a, b) min(a, b)
#define max_(a, b) max(a, b)
#define clamp_(x, lo, hi) clamp(x, lo, hi)
#define abs_(x) abs(x)
#define sqrt_(x) sqrt(x)
#define floor_(x) floor(x)
#define round_(x) floor((x) + 0.5)
#define native_exp(x) exp(x)
#define native_log(x) log(x)

#define v3(x, y, z) vec3(x, y, z)
#define v3_splat(s) vec3(s)
#define v3_add(a, b) ((a) + (b))
#define v3_sub(a, b) ((a) - (b))
#define v3_mul(a, b) ((a) * (b))
#define v3_scale(a, s) ((a) * (s))
#define v3_dot(a, b) dot(a, b)
#define v3_cross(a, b) cross(a, b)
#define v3_sel(c, a, b) ((c) ? (a) : (b))

#endif
