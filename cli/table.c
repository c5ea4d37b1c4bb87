/* SPDX-License-Identifier: Apache-2.0 */
#include "table.h"

#include "npy.h"
#include "number_text.h"
#include "report.h"

#include <stdint.h>
#include <string.h>

enum { MOST_NUMBERS = 9, ROW_ROOM = MOST_NUMBERS * (CLI_PRINT_ROOM + 1) + 4, PIECE = 64 };

static char *put_numbers(char *at, const float *v, size_t n, char between) {
    for (size_t i = 0; i < n; i++) {
        if (i) *at++ = between;
        at += cli_print_float(v[i], at);
    }
    return at;
}

static char *put_raw(char *at, const float *v, size_t n) {
    for (size_t i = 0; i < n; i++) {
        uint32_t bits;
        memcpy(&bits, &v[i], sizeof bits);
        for (int k = 0; k < 4; k++) *at++ = (char)(bits >> 8 * k & 255);
    }
    return at;
}

/* v: the directions, then the values. */
static char *put_row(const cli_table *t, char *at, bool first, const float *v) {
    switch (t->format) {
    case CLI_LINES: at = put_numbers(at, v + 6, t->columns, ' '); break;
    case CLI_CSV: at = put_numbers(at, v, 6 + t->columns, ','); break;
    case CLI_RAW:
    case CLI_NPY: return put_raw(at, v + 6, t->columns);
    case CLI_JSON:
        if (!first) *at++ = ',';
        *at++ = '\n';
        *at++ = '[';
        at = put_numbers(at, v + 6, t->columns, ',');
        *at++ = ']';
        return at;
    }
    *at++ = '\n';
    return at;
}

void cli_table_begin(cli_table *t) {
    if (t->format == CLI_CSV) {
        nd_text_add(&t->text, "wi.x,wi.y,wi.z,wo.x,wo.y,wo.z,");
        nd_text_add(&t->text, t->columns == 3 ? "r,g,b" : t->quantity);
        nd_text_add(&t->text, "\n");
    } else if (t->format == CLI_JSON) {
        nd_text_add(&t->text, "{\"material\":");
        nd_text_json(&t->text, t->material);
        nd_text_add(&t->text, ",\"quantity\":");
        nd_text_json(&t->text, t->quantity);
        nd_text_add(&t->text, ",\"unit\":");
        nd_text_json(&t->text, t->unit);
        nd_text_add(&t->text, ",\"rows\":[");
    }
}

int cli_table_add(cli_table *t, const cli_pairs *p, ndl_rgb_n rgb) {
    char piece[PIECE * ROW_ROOM], *at = piece;
    for (size_t i = 0; i < p->n; i++) {
        float v[MOST_NUMBERS] = {p->ix[i], p->iy[i], p->iz[i], p->ox[i], p->oy[i],
                                 p->oz[i], rgb.r[i], rgb.g[i], rgb.b[i]};
        at = put_row(t, at, t->rows++ == 0, v);
        if (i + 1 < p->n && i % PIECE != PIECE - 1) continue;
        nd_text_bytes(&t->text, piece, (size_t)(at - piece));
        at = piece;
    }
    bool whole = t->format == CLI_JSON || t->format == CLI_NPY;
    return whole || !t->text.n ? CLI_OK : cli_put_text(t->verb, &t->text);
}

int cli_table_end(cli_table *t) {
    if (t->format == CLI_JSON) nd_text_add(&t->text, "\n]}\n");
    if (t->format == CLI_NPY) {
        char header[CLI_NPY_HEADER];
        cli_npy_header(t->rows, t->columns, header);
        int code = cli_put(t->verb, header, sizeof header);
        if (code) return code;
    }
    return t->text.n || t->text.failed ? cli_put_text(t->verb, &t->text) : CLI_OK;
}
