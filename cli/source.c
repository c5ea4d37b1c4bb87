/* SPDX-License-Identifier: Apache-2.0 */
/* The three kinds of input of `eval`. Text and raw numbers stream through one buffer; a .npy array
   is read whole, because its columns may come one after the other. */
#include "directions.h"
#include "feed.h"
#include "npy.h"
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { TEXT, RAW, NPY } format;

struct cli_source {
    cli_feed feed;
    format format;
    bool angles;
    int failed;             /* exit code of a malformed row, already reported */
    unsigned long long off; /* rows with a direction whose length is not 1 */
    nd_text whole;          /* a .npy file */
    cli_npy array;
};

static int read_whole(cli_source *s) {
    cli_feed *f = &s->feed;
    while (!f->at_end) {
        nd_text_bytes(&s->whole, f->buffer + f->at, f->end - f->at);
        f->at = f->end = 0;
        int code = cli_feed_fill(f);
        if (code) return code;
    }
    if (s->whole.failed) return cli_error(f->verb, CLI_FAILED, f->name, "out of memory");
    const char *wrong = cli_npy_view(s->whole.s, s->whole.n, s->angles ? 4 : 6, &s->array);
    return wrong ? cli_error(f->verb, CLI_FAILED, f->name, "%s", wrong) : CLI_OK;
}

static bool is_named_npy(const char *name) {
    size_t n = strlen(name);
    return n > 4 && strcmp(name + n - 4, ".npy") == 0;
}

/* Looks at the first bytes. */
static int recognise(cli_source *s, bool raw) {
    cli_feed *f = &s->feed;
    int code = CLI_OK;
    do
        code = cli_feed_fill(f);
    while (!code && !f->at_end && f->end < CLI_NPY_MAGIC && cli_npy_begins(f->buffer, f->end));
    if (code) return code;
    bool npy = f->end >= CLI_NPY_MAGIC && cli_npy_begins(f->buffer, f->end);
    if (!npy && is_named_npy(f->name))
        return cli_error(f->verb, CLI_FAILED, f->name, "is not a .npy file");
    s->format = npy ? NPY : raw ? RAW : TEXT;
    f->raw = s->format != TEXT;
    if (s->format == TEXT) cli_feed_skip_mark(f);
    return npy ? read_whole(s) : CLI_OK;
}

int cli_source_open(const char *verb, const char *path, bool raw, bool angles,
                    cli_source **source) {
    cli_source *s = calloc(1, sizeof *s);
    if (!s) return cli_error(verb, CLI_FAILED, NULL, "out of memory");
    s->angles = angles;
    int code = cli_feed_open(&s->feed, verb, path);
    if (!code) code = recognise(s, raw);
    if (code)
        cli_source_close(s);
    else
        *source = s;
    return code;
}

void cli_source_close(cli_source *s) {
    if (s->off > 1)
        cli_warning(s->feed.verb, s->feed.name,
                    "%llu rows in all had directions that are no unit vectors", s->off);
    cli_feed_close(&s->feed);
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
    if (wrong)
        return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                         "%s; give a direction", wrong);
    if (fabs(length - 1.0) > 1e-3 && s->off++ == 0)
        cli_warning(s->feed.verb, cli_feed_place(&s->feed).s,
                    "a direction of length %.9g was normalised", length);
    return CLI_OK;
}

static int wrong_count(const cli_source *s, int found) {
    int wanted = s->angles ? 4 : 6;
    const char *hint = found == 4 && wanted == 6   ? "; for angles in degrees add --angles"
                       : found == 6 && wanted == 4 ? "; for directions drop --angles"
                                                   : "";
    return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                     "expected %d numbers, found %d%s", wanted, found, hint);
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
    return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                     "'%s' %s; expected %d numbers", n && !*at ? "\\x00" : cli_quote(token).s, what,
                     wanted);
}

/* Rows until the batch is full or no whole row is left in the buffer. */
static int next_rows(cli_source *s, cli_pairs *pairs) {
    int columns = s->angles ? 4 : 6;
    while (pairs->n < CLI_BATCH) {
        const char *line = NULL, *end = NULL;
        double v[6];
        bool wait = pairs->n == 0;
        cli_fed fed = s->feed.raw ? cli_feed_numbers(&s->feed, wait, columns, v)
                                  : cli_feed_line(&s->feed, wait, &line, &end);
        if (fed != CLI_FEED_ROW) return fed == CLI_FEED_FAILED ? CLI_FAILED : CLI_OK;
        int code = s->feed.raw ? add(s, pairs, v) : take_line(s, pairs, line, end);
        if (code) return code;
    }
    return CLI_OK;
}

static int next_npy(cli_source *s, cli_pairs *pairs) {
    while (pairs->n < CLI_BATCH && s->feed.row < s->array.rows) {
        double v[6];
        size_t row = (size_t)s->feed.row++;
        for (size_t i = 0; i < s->array.columns; i++)
            v[i] = cli_npy_value(&s->array, row, i);
        int code = add(s, pairs, v);
        if (code) return code;
    }
    return CLI_OK;
}

int cli_source_next(cli_source *s, cli_pairs *pairs) {
    pairs->n = 0;
    if (s->failed) return s->failed;
    int code = s->format == NPY ? next_npy(s, pairs) : next_rows(s, pairs);
    if (!code || !pairs->n) return code;
    s->failed = code; /* what came before it is still evaluated */
    return CLI_OK;
}
