/* SPDX-License-Identifier: Apache-2.0 */
#include "manual.h"

#include "ndotl/ndotl.h"
#include "wrap.h"

#include <math.h>
#include <string.h>

enum { INDENT = 2, FEEL_INDENT = 6 };

cli_heading_text cli_heading(const ndl_manual *section) {
    cli_heading_text h = {{0}};
    for (size_t i = 0; section->heading[i] && i + 1 < sizeof h.s; i++) {
        char c = section->heading[i];
        h.s[i] = c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
    }
    return h;
}

/* The text of the section "what" of model i, "" where it has none. */
static const char *what_is(size_t model) {
    size_t count;
    const ndl_manual *manual = ndl_model_manual(model, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(cli_heading(&manual[i]).s, "what") == 0) return manual[i].text;
    return "";
}

void cli_summary(nd_text *t, size_t model) {
    const char *what = what_is(model);
    const char *end = strstr(what, ". ");
    nd_text_bytes(t, what, end ? (size_t)(end - what) : strlen(what) - (*what != '\0'));
}

static bool is_unbounded(double x) {
    return fabs(x) > 1e38;
}

static void add_range(nd_text *t, const ndl_param *p) {
    nd_text_add(t, p->above_low || is_unbounded(p->low) ? "(" : "[");
    if (is_unbounded(p->low)) nd_text_add(t, "-inf");
    else nd_text_float(t, (float)p->low);
    nd_text_add(t, ", ");
    if (is_unbounded(p->high)) nd_text_add(t, "inf)");
    else nd_text_float(t, (float)p->high);
    if (!is_unbounded(p->high)) nd_text_add(t, "]");
}

static void add_initial(nd_text *t, const ndl_param *p, const char *open, const char *close) {
    const double *v = p->initial;
    bool grey = p->kind == NDL_KIND_NUMBER || (v[0] == v[1] && v[1] == v[2]);
    if (!grey) nd_text_add(t, open);
    for (int i = 0; i < (grey ? 1 : 3); i++) {
        if (i) nd_text_add(t, ", ");
        nd_text_float(t, (float)v[i]);
    }
    if (!grey) nd_text_add(t, close);
}

static const char *const kinds[] = {
    [NDL_KIND_NUMBER] = "number", [NDL_KIND_COLOR] = "color", [NDL_KIND_CHOICE] = "choice",
    [NDL_KIND_RAMP] = "ramp",     [NDL_KIND_WORD] = "word",   [NDL_KIND_VECTOR] = "vector",
};

static void add_words(nd_text *t, const ndl_param *p) {
    nd_text_add(t, "one of: ");
    nd_text_add(t, p->words);
    if (!p->initial_word) return;
    nd_text_add(t, "; default ");
    nd_text_add(t, p->initial_word);
}

/* "alpha  number in [0, 4], default 0.3, unit 1; another way to give width" and its feel. */
static void add_param(nd_text *t, const ndl_param *p) {
    nd_text line = {0};
    bool ranged = p->kind == NDL_KIND_NUMBER || p->kind == NDL_KIND_COLOR;
    nd_text_add(&line, p->key);
    nd_text_add(&line, ": ");
    if (p->kind == NDL_KIND_CHOICE) add_words(&line, p);
    else nd_text_add(&line, kinds[p->kind]);
    if (ranged) {
        nd_text_add(&line, " in ");
        add_range(&line, p);
    }
    if (p->kind != NDL_KIND_CHOICE && !isnan(p->initial[0])) {
        nd_text_add(&line, ", default ");
        add_initial(&line, p, "[", "]");
    }
    if (*p->unit) {
        nd_text_add(&line, ", unit ");
        nd_text_add(&line, p->unit);
    }
    if (strcmp(p->unit, "rad") == 0) {
        nd_text_add(&line, "; in degrees as ");
        nd_text_add(&line, p->key);
        nd_text_add(&line, "_deg");
    }
    if (p->is_spelling && p->group) {
        nd_text_add(&line, "; spells ");
        nd_text_add(&line, p->group);
    }
    cli_spaces(t, INDENT);
    if (line.s) cli_wrap(t, line.s, INDENT, FEEL_INDENT);
    cli_spaces(t, FEEL_INDENT);
    cli_wrap(t, p->feel, FEEL_INDENT, FEEL_INDENT);
    nd_text_free(&line);
}

static const struct { unsigned claim; const char *name, *text; } laws[] = {
    {NDL_CLAIM_RECIPROCITY, "reciprocity", "reciprocity"},
    {NDL_CLAIM_ENERGY, "energy", "energy conservation (directional albedo <= 1)"},
    {NDL_CLAIM_CONTINUITY, "continuity", "continuity of brdf_cos"},
};

/* The claims of the model with its default parameters. */
static unsigned default_claims(size_t model) {
    ndl_material *m = ndl_material_parse(ndl_model_name(model), NULL);
    unsigned claims = m ? ndl_material_claims(m) : 0;
    ndl_material_free(m);
    return claims;
}

static void add_laws(nd_text *t, size_t model) {
    unsigned claims = default_claims(model);
    nd_text line = {0};
    nd_text_add(&line, "Claimed with the default parameters: finite, non-negative, 0 outside the "
                       "lit gate");
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        if (!(claims & laws[i].claim)) continue;
        nd_text_add(&line, ", ");
        nd_text_add(&line, laws[i].text);
    }
    nd_text_add(&line, ".");
    nd_text_add(t, "\nlaws\n");
    cli_spaces(t, INDENT);
    if (line.s) cli_wrap(t, line.s, INDENT, INDENT);
    nd_text_free(&line);
}

void cli_manual(nd_text *t, size_t model) {
    size_t count, params;
    const ndl_manual *manual = ndl_model_manual(model, &count);
    const ndl_param *param = ndl_model_params(model, &params);
    nd_text_add(t, ndl_model_name(model));
    nd_text_add(t, "\n");
    for (size_t i = 0; i < count; i++) {
        nd_text_add(t, "\n");
        nd_text_add(t, cli_heading(&manual[i]).s);
        nd_text_add(t, "\n");
        cli_spaces(t, INDENT);
        cli_wrap(t, manual[i].text, INDENT, INDENT);
    }
    add_laws(t, model);
    nd_text_add(t, "\nparameters\n");
    for (size_t i = 0; i < params; i++) add_param(t, &param[i]);
}

static void add_string(nd_text *t, const char *key, const char *value) {
    nd_text_add(t, ",");
    nd_text_json(t, key);
    nd_text_add(t, ":");
    if (value) nd_text_json(t, value);
    else nd_text_add(t, "null");
}

static void add_bound(nd_text *t, const char *key, double x) {
    nd_text_add(t, ",");
    nd_text_json(t, key);
    nd_text_add(t, ":");
    if (is_unbounded(x)) nd_text_add(t, "null");
    else nd_text_float(t, (float)x);
}

static void param_json(nd_text *t, const ndl_param *p) {
    nd_text_add(t, "{\"key\":");
    nd_text_json(t, p->key);
    add_string(t, "kind", kinds[p->kind]);
    if (p->kind == NDL_KIND_NUMBER || p->kind == NDL_KIND_COLOR) {
        add_bound(t, "low", p->low);
        add_bound(t, "high", p->high);
        nd_text_add(t, p->above_low ? ",\"above_low\":true" : ",\"above_low\":false");
    }
    if (p->kind == NDL_KIND_CHOICE) {
        add_string(t, "words", p->words);
        add_string(t, "default", p->initial_word);
    } else {
        nd_text_add(t, ",\"default\":");
        if (isnan(p->initial[0])) nd_text_add(t, "null");
        else add_initial(t, p, "[", "]");
    }
    add_string(t, "unit", p->unit);
    add_string(t, "spells", p->is_spelling ? p->group : NULL);
    add_string(t, "feel", p->feel);
    nd_text_add(t, "}");
}

void cli_manual_json(nd_text *t, size_t model) {
    size_t count, params;
    const ndl_manual *manual = ndl_model_manual(model, &count);
    const ndl_param *param = ndl_model_params(model, &params);
    unsigned claims = default_claims(model);
    nd_text_add(t, "{\"name\":");
    nd_text_json(t, ndl_model_name(model));
    nd_text_add(t, ",\"manual\":{");
    for (size_t i = 0; i < count; i++) {
        nd_text_add(t, i ? "," : "");
        nd_text_json(t, cli_heading(&manual[i]).s);
        nd_text_add(t, ":");
        nd_text_json(t, manual[i].text);
    }
    nd_text_add(t, "},\"claims\":[\"finite\",\"non_negative\",\"lit_gate\"");
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        if (!(claims & laws[i].claim)) continue;
        nd_text_add(t, ",");
        nd_text_json(t, laws[i].name);
    }
    nd_text_add(t, "],\"params\":[");
    for (size_t i = 0; i < params; i++) {
        nd_text_add(t, i ? ",\n" : "\n");
        param_json(t, &param[i]);
    }
    nd_text_add(t, "\n]}\n");
}
