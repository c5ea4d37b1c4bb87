/* SPDX-License-Identifier: Apache-2.0 */
#include "directions.h"

#include "ndotl/convert.h"
#include "number_text.h"

#include <math.h>
#include <string.h>

const char *cli_pairs_add(cli_pairs *to, const double *v, bool angles, double *off) {
    ndl_vec3 wi, wo;
    double li, lo;
    if (angles) {
        li = ndl_direction_deg(v[0], v[1], &wi);
        lo = ndl_direction_deg(v[2], v[3], &wo);
    } else {
        li = ndl_direction(v[0], v[1], v[2], &wi);
        lo = ndl_direction(v[3], v[4], v[5], &wo);
    }
    if (!isfinite(li) || !isfinite(lo))
        return isfinite(li) ? "wo is not finite" : "wi is not finite";
    if (li == 0.0 || lo == 0.0) return li == 0.0 ? "wi is zero" : "wo is zero";
    *off = fabs(li - 1.0) >= fabs(lo - 1.0) ? li : lo;
    size_t n = to->n++;
    to->ix[n] = wi.x;
    to->iy[n] = wi.y;
    to->iz[n] = wi.z;
    to->ox[n] = wo.x;
    to->oy[n] = wo.y;
    to->oz[n] = wo.z;
    return NULL;
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

static const char *skip_blanks(const char *s, const char *end) {
    while (s < end && is_blank(*s)) s++;
    return s;
}

/* The token that begins at s, for a message. */
static size_t token(const char *s, const char *end) {
    const char *p = s;
    while (p < end && !is_blank(*p) && *p != ',' && *p != '#') p++;
    return p > s ? (size_t)(p - s) : (size_t)(s < end);
}

static bool ends_number(const char *s, const char *end) {
    return s == end || is_blank(*s) || *s == ',' || *s == '#';
}

int cli_line_numbers(const char *s, const char *end, double *v, int most, const char **what,
                     const char **at, size_t *n) {
    int count = 0;
    const char *p = skip_blanks(s, end);
    while (p < end && *p != '#') {
        double x;
        size_t used = cli_scan_double(p, end, &x);
        *at = p;
        *n = token(p, end);
        if (!used || !ends_number(p + used, end)) {
            *what = "is no number";
            return -1;
        }
        if (!isfinite(x)) {
            *what = "is too large";
            return -1;
        }
        if (count < most) v[count] = x;
        if (count < 1000) count++;
        p = skip_blanks(p + used, end);
        if (p == end || *p != ',') continue;
        *at = p++;
        *n = 1;
        p = skip_blanks(p, end);
        if (p == end || *p == '#' || *p == ',') {
            *what = "has no number behind it";
            return -1;
        }
    }
    return count;
}
