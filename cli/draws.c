/* SPDX-License-Identifier: Apache-2.0 */
#include "draws.h"

#include "base/stream.h"
#include "ndotl/convert.h"
#include "render/sampler.h"
#include "report.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BUFFER = 1 << 20, NUMBERS = 6, RAW_BYTES = 4 * NUMBERS }; /* the longest line, too */

struct cli_draw_source {
    const char *verb, *name;
    int stream;
    bool raw, at_end;
    int failed;              /* exit code of a malformed row, already reported */
    uint64_t start;          /* of the random numbers */
    unsigned long long line; /* lines, or raw rows, taken so far */
    unsigned long long rows; /* rows taken so far: lines with numbers */
    unsigned long long off;  /* rows whose wo was no unit vector */
    size_t at, end;          /* the unread part of the buffer */
    char buffer[BUFFER];
};

/* "FILE:LINE" of the row that is being taken. */
typedef struct {
    char s[4200];
} row_place;

static row_place place(const cli_draw_source *s) {
    row_place p;
    snprintf(p.s, sizeof p.s, "%s:%s%llu", s->name, s->raw ? " row " : "", s->line);
    return p;
}

int cli_draws_open(const char *verb, const char *path, bool raw, uint64_t seed,
                   cli_draw_source **source) {
    bool standard = !path || strcmp(path, "-") == 0;
    cli_draw_source *s = calloc(1, sizeof *s);
    if (!s) return cli_error(verb, CLI_FAILED, NULL, "out of memory");
    s->verb = verb;
    s->name = standard ? "stdin" : path;
    s->raw = raw;
    s->start = nd_mix(seed + 0x9e3779b97f4a7c15u);
    s->stream = standard ? ND_STDIN : nd_stream_open(path);
    if (s->stream < 0) {
        free(s);
        return cli_error(verb, CLI_FAILED, path, "cannot be opened: %s", strerror(errno));
    }
    *source = s;
    return CLI_OK;
}

void cli_draws_close(cli_draw_source *s) {
    if (s->off > 1)
        cli_warning(s->verb, s->name, "%llu rows in all had a wo that is no unit vector", s->off);
    if (s->stream > ND_STDIN) nd_stream_close(s->stream);
    free(s);
}

/* Reads more behind the unread part. 0, or 1 after a message. */
static int fill(cli_draw_source *s) {
    memmove(s->buffer, s->buffer + s->at, s->end - s->at);
    s->end -= s->at;
    s->at = 0;
    ptrdiff_t got = nd_stream_read(s->stream, s->buffer + s->end, BUFFER - s->end);
    if (got < 0)
        return cli_error(s->verb, CLI_FAILED, s->name, "cannot be read: %s", strerror(errno));
    s->at_end = got == 0;
    s->end += (size_t)got;
    return CLI_OK;
}

/* Number k of this row: SplitMix64, entered at its place. Source: [Steele14]. */
static float random_number(const cli_draw_source *s, unsigned k) {
    uint64_t place = 3 * (uint64_t)s->rows + k + 1;
    return (float)(nd_mix(s->start + place * 0x9e3779b97f4a7c15u) >> 40) * 0x1p-24f;
}

/* Takes one row, with or without u; 0, or 1 after a message. Only the first wo that is no unit
   vector is reported at once, the others are counted. */
static int add(cli_draw_source *s, cli_draws *to, const double *v, bool with_u) {
    ndl_vec3 wo;
    double length = ndl_direction(v[0], v[1], v[2], &wo);
    if (!isfinite(length) || length == 0.0)
        return cli_error(s->verb, CLI_FAILED, place(s).s, "wo is %s; give a direction",
                         length == 0.0 ? "zero" : "not finite");
    for (unsigned k = 0; k < 3; k++) {
        double u = with_u ? v[3 + k] : (double)random_number(s, k);
        if (!(u >= 0.0 && u < 1.0))
            return cli_error(s->verb, CLI_FAILED, place(s).s,
                             "u%u is %.9g; give a number in [0, 1)", k, u);
        /* The float nearest to a number just below 1 would be 1. */
        to->u[k][to->n] = fminf((float)u, 0x1.fffffep-1f);
    }
    if (fabs(length - 1.0) > 1e-3 && s->off++ == 0)
        cli_warning(s->verb, place(s).s, "a direction of length %.9g was normalised", length);
    to->wo[0][to->n] = wo.x;
    to->wo[1][to->n] = wo.y;
    to->wo[2][to->n++] = wo.z;
    s->rows++;
    return CLI_OK;
}

/* Takes the line [line, end); 0, or 1 after a message. */
static int take_line(cli_draw_source *s, cli_draws *to, const char *line, const char *end) {
    double v[NUMBERS];
    const char *what = NULL, *at = NULL;
    size_t n = 0;
    int found = cli_line_numbers(line, end, v, NUMBERS, &what, &at, &n);
    if (found == 0) return CLI_OK;
    if (found == 3 || found == NUMBERS) return add(s, to, v, found == NUMBERS);
    if (found > 0)
        return cli_error(s->verb, CLI_FAILED, place(s).s,
                         "expected 6 numbers, wo and u, or 3, wo alone; found %d", found);
    char token[64];
    snprintf(token, sizeof token, "%.*s", n < 60 ? (int)n : 60, at);
    return cli_error(s->verb, CLI_FAILED, place(s).s, "'%s' %s; expected 6 numbers or 3",
                     n && !*at ? "\\x00" : cli_quote(token).s, what);
}

/* A line that does not fit into the buffer. */
static int too_long(cli_draw_source *s) {
    s->line++;
    return cli_error(s->verb, CLI_FAILED, place(s).s, "the line is longer than %d bytes", BUFFER);
}

/* Lines until the batch is full or no whole line is left in the buffer. */
static int next_lines(cli_draw_source *s, cli_draws *to) {
    while (to->n < CLI_BATCH) {
        const char *line = s->buffer + s->at;
        const char *end = memchr(line, '\n', s->end - s->at);
        if (end || (s->at_end && s->at < s->end)) {
            s->line++;
            int code = take_line(s, to, line, end ? end : s->buffer + s->end);
            if (code) return code;
            s->at = end ? (size_t)(end - s->buffer) + 1 : s->end;
        } else {
            if (s->at_end || to->n) return CLI_OK;
            int code = s->end - s->at == BUFFER ? too_long(s) : fill(s);
            if (code) return code;
        }
    }
    return CLI_OK;
}

static double little_endian_float(const char *s) {
    const unsigned char *b = (const unsigned char *)s;
    uint32_t bits = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    float x;
    memcpy(&x, &bits, sizeof x);
    return (double)x;
}

static int next_raw(cli_draw_source *s, cli_draws *to) {
    while (to->n < CLI_BATCH) {
        size_t left = s->end - s->at;
        if (left < RAW_BYTES && s->at_end) {
            s->at = s->end;
            s->line++;
            if (!left) return CLI_OK;
            return cli_error(s->verb, CLI_FAILED, place(s).s, "cut off: %d of %d bytes are there",
                             (int)left, RAW_BYTES);
        }
        if (left < RAW_BYTES) {
            if (to->n) return CLI_OK;
            int code = fill(s);
            if (code) return code;
            continue;
        }
        double v[NUMBERS];
        for (int k = 0; k < NUMBERS; k++)
            v[k] = little_endian_float(s->buffer + s->at + 4 * k);
        s->at += RAW_BYTES;
        s->line++;
        int code = add(s, to, v, true);
        if (code) return code;
    }
    return CLI_OK;
}

int cli_draws_next(cli_draw_source *s, cli_draws *to) {
    to->n = 0;
    if (s->failed) return s->failed;
    int code = s->raw ? next_raw(s, to) : next_lines(s, to);
    if (!code || !to->n) return code;
    s->failed = code; /* what came before it is still drawn */
    return CLI_OK;
}
