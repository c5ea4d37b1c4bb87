/* SPDX-License-Identifier: Apache-2.0 */
/* Searching the registry and the manuals. */
#include "manual.h"
#include "ndotl/ndotl.h"
#include "wrap.h"

#include <stdlib.h>
#include <string.h>

/* Functions of the shading text by the rows that they compute: ROW(row, function, file). */
static const struct { const char *row, *function, *file; } functions[] = {
#define ROW(row, function, file) {row, function, file},
#include "rows.inc"
#undef ROW
    {"", "", ""},
};

/* One place where a term stands. */
typedef struct {
    const char *kind; /* "word", "key", "preset", "function", "manual" */
    const char *name; /* of the word, key, preset or function; the heading of a manual */
    const char *owner; /* the key of a word, the file of a function, else "" */
    const char *model; /* or "" */
    const char *text;  /* a sentence, or the feel of a key */
    size_t length;
} hit;

typedef void (*hit_writer)(nd_text *t, const hit *h, bool first);

typedef struct {
    nd_text *t;
    hit_writer write;
    size_t count;
} hits;

static void report(hits *to, hit h) {
    to->write(to->t, &h, to->count++ == 0);
}

/* ---- rows: S1.2, also inside "S1.1 to S1.4" -------------------------------------------------- */

typedef struct { int document, row; } row_id;

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* Reads a row id at s; its length, or 0. */
static size_t read_row(const char *s, row_id *id) {
    if (s[0] != 'S' || !is_digit(s[1]) || s[2] != '.' || !is_digit(s[3])) return 0;
    size_t n = 3;
    id->document = s[1] - '0';
    id->row = 0;
    for (; is_digit(s[n]) && n < 6; n++) id->row = 10 * id->row + (s[n] - '0');
    return n;
}

/* The place in text where the row is named, alone or by a range; NULL. */
static const char *find_row(const char *text, row_id wanted) {
    for (const char *s = strchr(text, 'S'); s; s = strchr(s + 1, 'S')) {
        row_id first, last;
        size_t n = read_row(s, &first);
        if (!n) continue;
        last = first;
        if (strncmp(s + n, " to ", 4) == 0 && !read_row(s + n + 4, &last)) last = first;
        if (first.document == wanted.document && last.document == wanted.document &&
            first.row <= wanted.row && wanted.row <= last.row)
            return s;
    }
    return NULL;
}

/* ---- terms ----------------------------------------------------------------------------------- */

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool begins(const char *s, const char *term) {
    for (; *term; s++, term++)
        if (lower(*s) != lower(*term)) return false;
    return true;
}

static const char *find_term(const char *text, const char *term) {
    for (; *text; text++)
        if (begins(text, term)) return text;
    return NULL;
}

/* A full stop that ends a sentence: not that of a number or of "eq. 5". */
static bool ends_sentence(const char *s) {
    return s[0] == '.' && s[1] == ' ' && s[2] >= 'A' && s[2] <= 'Z';
}

/* The sentence of text around `at`. */
static void sentence(hit *h, const char *text, const char *at) {
    const char *start = at, *end = at;
    while (start > text && !(start - text >= 2 && ends_sentence(start - 2))) start--;
    while (*end && !ends_sentence(end)) end++;
    h->text = start;
    h->length = (size_t)(end - start) + (*end != '\0');
}

static void find_in_manuals(hits *to, const char *term, const row_id *row) {
    for (size_t i = 0; i < ndl_model_count(); i++) {
        size_t count;
        const ndl_manual *m = ndl_model_manual(i, &count);
        for (size_t k = 0; k < count; k++) {
            const char *at = row ? find_row(m[k].text, *row) : find_term(m[k].text, term);
            if (!at) continue;
            cli_heading_text heading = cli_heading(&m[k]);
            hit h = {"manual", heading.s, "", ndl_model_name(i), NULL, 0};
            sentence(&h, m[k].text, at);
            report(to, h);
        }
    }
}

/* Words of a choice that contain the term. */
static void find_in_words(hits *to, const char *term, const char *model, const ndl_param *p) {
    for (const char *s = p->words; s && *s;) {
        char word[64];
        size_t n = strcspn(s, " ");
        if (n < sizeof word) {
            memcpy(word, s, n);
            word[n] = '\0';
            if (find_term(word, term))
                report(to, (hit){"word", word, p->key, model, p->feel, strlen(p->feel)});
        }
        s += n + (s[n] == ' ');
    }
}

static void find_in_params(hits *to, const char *term) {
    for (size_t i = 0; i < ndl_model_count(); i++) {
        size_t count;
        const char *model = ndl_model_name(i);
        const ndl_param *p = ndl_model_params(i, &count);
        for (size_t k = 0; k < count; k++) {
            if (find_term(p[k].key, term))
                report(to, (hit){"key", p[k].key, "", model, p[k].feel, strlen(p[k].feel)});
            find_in_words(to, term, model, &p[k]);
        }
    }
    for (size_t i = 0; i < ndl_preset_count(); i++) {
        const ndl_preset *p = ndl_preset_at(i);
        if (find_term(p->name, term))
            report(to, (hit){"preset", p->name, "", "", p->source, strlen(p->source)});
    }
}

static void find_functions(hits *to, const char *term) {
    for (size_t i = 0; functions[i].row[0]; i++)
        if (strcmp(functions[i].row, term) == 0)
            report(to, (hit){"function", functions[i].function, functions[i].file, "", "", 0});
}

static bool find_all(nd_text *t, const char *term, hit_writer write) {
    hits to = {t, write, 0};
    row_id row;
    size_t n = read_row(term, &row);
    if (!*term) return false;
    if (n && !term[n]) {
        find_functions(&to, term);
        find_in_manuals(&to, NULL, &row);
    } else {
        find_in_params(&to, term);
        find_in_manuals(&to, term, NULL);
    }
    return to.count > 0;
}

static void write_hit(nd_text *t, const hit *h, bool first) {
    nd_text line = {0};
    (void)first;
    if (*h->model) {
        nd_text_add(&line, h->model);
        nd_text_add(&line, ", ");
    }
    nd_text_add(&line, *h->owner && strcmp(h->kind, "word") == 0 ? h->owner : h->kind);
    nd_text_add(&line, strcmp(h->kind, "word") == 0 ? "=" : " ");
    nd_text_add(&line, h->name);
    if (strcmp(h->kind, "function") == 0) {
        nd_text_add(&line, " in src/shade/");
        nd_text_add(&line, h->owner);
    }
    nd_text_add(t, line.s ? line.s : "");
    nd_text_add(t, "\n");
    nd_text_free(&line);
    if (!h->length) return;
    nd_text_bytes(&line, h->text, h->length);
    cli_spaces(t, 4);
    if (line.s) cli_wrap(t, line.s, 4, 4);
    nd_text_free(&line);
}

static void write_hit_json(nd_text *t, const hit *h, bool first) {
    nd_text text = {0};
    const char *const parts[][2] = {
        {"{\"kind\":", h->kind}, {",\"name\":", h->name}, {",\"of\":", h->owner},
        {",\"model\":", h->model},
    };
    nd_text_add(t, first ? "\n" : ",\n");
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        nd_text_add(t, parts[i][0]);
        nd_text_json(t, parts[i][1]);
    }
    nd_text_bytes(&text, h->text, h->length);
    nd_text_add(t, ",\"text\":");
    nd_text_json(t, text.s ? text.s : "");
    nd_text_add(t, "}");
    nd_text_free(&text);
}

bool cli_find(nd_text *t, const char *term) {
    return find_all(t, term, write_hit);
}

bool cli_find_json(nd_text *t, const char *term) {
    nd_text_add(t, "{\"term\":");
    nd_text_json(t, term);
    nd_text_add(t, ",\"found\":[");
    bool found = find_all(t, term, write_hit_json);
    nd_text_add(t, "\n]}\n");
    return found;
}
