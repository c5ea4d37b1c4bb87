/* SPDX-License-Identifier: Apache-2.0 */
/* The three kinds of input of `eval`. Text and raw numbers stream through one buffer; a .npy array
   is read whole, because its columns may come one after the other. */
#include "base/stream.h"
#include "directions.h"
#include "npy.h"
#include "report.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BUFFER = 1 << 20 }; /* the longest line, too */

typedef enum { TEXT, RAW, NPY } format;

struct cli_source {
    const char *verb, *name;
    int stream;
    format format;
    bool angles, at_end;
    int failed;             /* exit code of a malformed row, already reported */
    unsigned long long row; /* lines or rows taken so far */
    unsigned long long off; /* rows with a direction whose length is not 1 */
    size_t at, end;         /* the unread part of the buffer */
    nd_text whole;          /* a .npy file */
    cli_npy array;
    char buffer[BUFFER];
};

/* "FILE:LINE" of the row that is being taken. */
typedef struct { char s[4200]; } row_place;

static row_place place(const cli_source *s) {
    row_place p;
    snprintf(p.s, sizeof p.s, "%s:%s%llu", s->name, s->format == TEXT ? "" : " row ", s->row);
    return p;
}

static int unreadable(const cli_source *s) {
    return cli_error(s->verb, CLI_FAILED, s->name, "cannot be read: %s", strerror(errno));
}

/* Reads more behind the unread part. 0, or 1 after a message. */
static int fill(cli_source *s) {
    memmove(s->buffer, s->buffer + s->at, s->end - s->at);
    s->end -= s->at;
    s->at = 0;
    ptrdiff_t got = nd_stream_read(s->stream, s->buffer + s->end, BUFFER - s->end);
    if (got < 0) return unreadable(s);
    s->at_end = got == 0;
    s->end += (size_t)got;
    return CLI_OK;
}

static int read_whole(cli_source *s) {
    while (!s->at_end) {
        nd_text_bytes(&s->whole, s->buffer + s->at, s->end - s->at);
        s->at = s->end = 0;
        int code = fill(s);
        if (code) return code;
    }
    if (s->whole.failed) return cli_error(s->verb, CLI_FAILED, s->name, "out of memory");
    const char *wrong = cli_npy_view(s->whole.s, s->whole.n, s->angles ? 4 : 6, &s->array);
    return wrong ? cli_error(s->verb, CLI_FAILED, s->name, "%s", wrong) : CLI_OK;
}

static bool is_named_npy(const char *name) {
    size_t n = strlen(name);
    return n > 4 && strcmp(name + n - 4, ".npy") == 0;
}

/* Looks at the first bytes. */
static int recognise(cli_source *s, bool raw) {
    int code = CLI_OK;
    do code = fill(s);
    while (!code && !s->at_end && s->end < CLI_NPY_MAGIC && cli_npy_begins(s->buffer, s->end));
    if (code) return code;
    bool npy = s->end >= CLI_NPY_MAGIC && cli_npy_begins(s->buffer, s->end);
    if (!npy && is_named_npy(s->name))
        return cli_error(s->verb, CLI_FAILED, s->name, "is not a .npy file");
    s->format = npy ? NPY : raw ? RAW : TEXT;
    /* A byte order mark, as some editors write it, is no part of the first line. */
    if (s->format == TEXT && s->end >= 3 && memcmp(s->buffer, "\xef\xbb\xbf", 3) == 0) s->at = 3;
    return npy ? read_whole(s) : CLI_OK;
}

int cli_source_open(const char *verb, const char *path, bool raw, bool angles,
                    cli_source **source) {
    bool standard = !path || strcmp(path, "-") == 0;
    cli_source *s = calloc(1, sizeof *s);
    if (!s) return cli_error(verb, CLI_FAILED, NULL, "out of memory");
    s->verb = verb;
    s->name = standard ? "stdin" : path;
    s->angles = angles;
    s->stream = standard ? ND_STDIN : nd_stream_open(path);
    int code = s->stream < 0
                   ? cli_error(verb, CLI_FAILED, path, "cannot be opened: %s", strerror(errno))
                   : recognise(s, raw);
    if (code) cli_source_close(s);
    else *source = s;
    return code;
}

void cli_source_close(cli_source *s) {
    if (s->off > 1)
        cli_warning(s->verb, s->name, "%llu rows in all had directions that are no unit vectors",
                    s->off);
    if (s->stream > ND_STDIN) nd_stream_close(s->stream);
    nd_text_free(&s->whole);
    free(s);
}

bool cli_source_is_npy(const cli_source *s) {
    return s->format == NPY;
}

/* Takes one row of numbers; 0, or 1 after a message. Only the first unnormalised row is reported at
   once, the others are counted. */
static int add(cli_source *s, cli_pairs *pairs, const double *v) {
    double length = 1.0;
    const char *wrong = cli_pairs_add(pairs, v, s->angles, &length);
    if (wrong) return cli_error(s->verb, CLI_FAILED, place(s).s, "%s; give a direction", wrong);
    if (fabs(length - 1.0) > 1e-3 && s->off++ == 0)
        cli_warning(s->verb, place(s).s, "a direction of length %.9g was normalised", length);
    return CLI_OK;
}

static int wrong_count(const cli_source *s, int found) {
    int wanted = s->angles ? 4 : 6;
    const char *hint = found == 4 && wanted == 6 ? "; for angles in degrees add --angles"
                       : found == 6 && wanted == 4 ? "; for directions drop --angles" : "";
    return cli_error(s->verb, CLI_FAILED, place(s).s, "expected %d numbers, found %d%s", wanted,
                     found, hint);
}

/* Takes the line [line, end); 0, or 1 after a message. */
static int take_line(cli_source *s, cli_pairs *pairs, const char *line, const char *end) {
    double v[6];
    const char *what = NULL, *at = NULL;
    size_t n = 0;
    int wanted = s->angles ? 4 : 6;
    int found = cli_line_numbers(line, end, v, wanted, &what, &at, &n);
    if (found == 0) return CLI_OK;
    if (found == wanted) return add(s, pairs, v);
    if (found > 0) return wrong_count(s, found);
    char token[64];
    snprintf(token, sizeof token, "%.*s", n < 60 ? (int)n : 60, at);
    return cli_error(s->verb, CLI_FAILED, place(s).s, "'%s' %s; expected %d numbers",
                     n && !*at ? "\\x00" : cli_quote(token).s, what, wanted);
}

/* A line that does not fit into the buffer. */
static int too_long(cli_source *s) {
    s->row++;
    return cli_error(s->verb, CLI_FAILED, place(s).s, "the line is longer than %d bytes", BUFFER);
}

/* Lines until the batch is full or no whole line is left in the buffer. */
static int next_lines(cli_source *s, cli_pairs *pairs) {
    while (pairs->n < CLI_BATCH) {
        const char *line = s->buffer + s->at;
        const char *end = memchr(line, '\n', s->end - s->at);
        if (end || (s->at_end && s->at < s->end)) {
            s->row++;
            int code = take_line(s, pairs, line, end ? end : s->buffer + s->end);
            if (code) return code;
            s->at = end ? (size_t)(end - s->buffer) + 1 : s->end;
        } else {
            if (s->at_end || pairs->n) return CLI_OK;
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

static int next_raw(cli_source *s, cli_pairs *pairs) {
    size_t columns = s->angles ? 4 : 6, bytes = 4 * columns;
    while (pairs->n < CLI_BATCH) {
        if (s->end - s->at >= bytes) {
            double v[6];
            for (size_t i = 0; i < columns; i++)
                v[i] = little_endian_float(s->buffer + s->at + 4 * i);
            s->at += bytes;
            s->row++;
            int code = add(s, pairs, v);
            if (code) return code;
        } else if (!s->at_end) {
            if (pairs->n) return CLI_OK;
            int code = fill(s);
            if (code) return code;
        } else {
            size_t rest = s->end - s->at;
            s->at = s->end;
            s->row++;
            if (!rest) return CLI_OK;
            return cli_error(s->verb, CLI_FAILED, place(s).s, "cut off: %d of %d bytes are there",
                             (int)rest, (int)bytes);
        }
    }
    return CLI_OK;
}

static int next_npy(cli_source *s, cli_pairs *pairs) {
    while (pairs->n < CLI_BATCH && s->row < s->array.rows) {
        double v[6];
        size_t row = (size_t)s->row++;
        for (size_t i = 0; i < s->array.columns; i++) v[i] = cli_npy_value(&s->array, row, i);
        int code = add(s, pairs, v);
        if (code) return code;
    }
    return CLI_OK;
}

int cli_source_next(cli_source *s, cli_pairs *pairs) {
    pairs->n = 0;
    if (s->failed) return s->failed;
    int code = s->format == TEXT  ? next_lines(s, pairs)
               : s->format == RAW ? next_raw(s, pairs)
                                  : next_npy(s, pairs);
    if (!code || !pairs->n) return code;
    s->failed = code; /* what came before it is still evaluated */
    return CLI_OK;
}
