/* SPDX-License-Identifier: Apache-2.0 */
#include "draws.h"

#include "feed.h"
#include "ndotl/convert.h"
#include "render/sampler.h"
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBERS = 6 };

struct cli_draw_source {
    cli_feed feed;
    int failed;              /* exit code of a malformed row, already reported */
    uint64_t start;          /* of the random numbers */
    unsigned long long rows; /* rows taken so far: lines with numbers */
    unsigned long long off;  /* rows whose wo was no unit vector */
};

int cli_draws_open(const char *verb, const char *path, bool raw, uint64_t seed,
                   cli_draw_source **source) {
    cli_draw_source *s = calloc(1, sizeof *s);
    if (!s) return cli_error(verb, CLI_FAILED, NULL, "out of memory");
    s->start = nd_mix(seed + 0x9e3779b97f4a7c15u);
    s->feed.raw = raw;
    int code = cli_feed_open(&s->feed, verb, path);
    if (!code) code = cli_feed_fill(&s->feed);
    if (!code && !raw) cli_feed_skip_mark(&s->feed);
    if (code)
        cli_draws_close(s);
    else
        *source = s;
    return code;
}

void cli_draws_close(cli_draw_source *s) {
    if (s->off > 1)
        cli_warning(s->feed.verb, s->feed.name, "%llu rows in all had a wo that is no unit vector",
                    s->off);
    cli_feed_close(&s->feed);
    free(s);
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
        return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                         "wo is %s; give a direction", length == 0.0 ? "zero" : "not finite");
    for (unsigned k = 0; k < 3; k++) {
        double u = with_u ? v[3 + k] : (double)random_number(s, k);
        if (!(u >= 0.0 && u < 1.0))
            return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                             "u%u is %.9g; give a number in [0, 1)", k, u);
        /* The float nearest to a number just below 1 would be 1. */
        to->u[k][to->n] = fminf((float)u, 0x1.fffffep-1f);
    }
    if (fabs(length - 1.0) > 1e-3 && s->off++ == 0)
        cli_warning(s->feed.verb, cli_feed_place(&s->feed).s,
                    "a direction of length %.9g was normalised", length);
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
        return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                         "expected 6 numbers, wo and u, or 3, wo alone; found %d", found);
    char token[64];
    snprintf(token, sizeof token, "%.*s", n < 60 ? (int)n : 60, at);
    return cli_error(s->feed.verb, CLI_FAILED, cli_feed_place(&s->feed).s,
                     "'%s' %s; expected 6 numbers or 3", n && !*at ? "\\x00" : cli_quote(token).s,
                     what);
}

/* Rows until the batch is full or no whole row is left in the buffer. */
static int next_rows(cli_draw_source *s, cli_draws *to) {
    while (to->n < CLI_BATCH) {
        const char *line = NULL, *end = NULL;
        double v[NUMBERS];
        bool wait = to->n == 0;
        cli_fed fed = s->feed.raw ? cli_feed_numbers(&s->feed, wait, NUMBERS, v)
                                  : cli_feed_line(&s->feed, wait, &line, &end);
        if (fed != CLI_FEED_ROW) return fed == CLI_FEED_FAILED ? CLI_FAILED : CLI_OK;
        int code = s->feed.raw ? add(s, to, v, true) : take_line(s, to, line, end);
        if (code) return code;
    }
    return CLI_OK;
}

int cli_draws_next(cli_draw_source *s, cli_draws *to) {
    to->n = 0;
    if (s->failed) return s->failed;
    int code = next_rows(s, to);
    if (!code || !to->n) return code;
    s->failed = code; /* what came before it is still drawn */
    return CLI_OK;
}
