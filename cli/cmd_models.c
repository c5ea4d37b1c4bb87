/* SPDX-License-Identifier: Apache-2.0 */
#include "base/nearest.h"
#include "manual.h"
#include "ndotl/ndotl.h"
#include "options.h"
#include "report.h"
#include "wrap.h"

#include <stdlib.h>
#include <string.h>

static const cli_option options[] = {
    {"--presets", NULL, NULL, false, "list the presets of substances and where they come from"},
    {"--json", NULL, NULL, false, "write JSON"},
    {NULL, NULL, NULL, false, NULL},
};

static void list(nd_text *t) {
    enum { WIDTH = 18 };
    for (size_t i = 0; i < ndl_model_count(); i++) {
        nd_text what = {0};
        const char *name = ndl_model_name(i);
        cli_summary(&what, i);
        nd_text_add(t, name);
        cli_spaces(t, strlen(name) < WIDTH ? WIDTH - strlen(name) : 1);
        cli_wrap(t, what.s ? what.s : "", WIDTH, WIDTH);
        nd_text_free(&what);
    }
}

static void list_json(nd_text *t) {
    nd_text_add(t, "{\"models\":[");
    for (size_t i = 0; i < ndl_model_count(); i++) {
        nd_text what = {0};
        cli_summary(&what, i);
        nd_text_add(t, i ? ",\n{\"name\":" : "\n{\"name\":");
        nd_text_json(t, ndl_model_name(i));
        nd_text_add(t, ",\"what\":");
        nd_text_json(t, what.s ? what.s : "");
        nd_text_add(t, "}");
        nd_text_free(&what);
    }
    nd_text_add(t, "\n]}\n");
}

static void add_rgb(nd_text *t, const float v[3]) {
    nd_text_add(t, "[");
    for (int c = 0; c < 3; c++) {
        if (c) nd_text_add(t, ",");
        nd_text_float(t, v[c]);
    }
    nd_text_add(t, "]");
}

static void presets(nd_text *t) {
    for (size_t i = 0; i < ndl_preset_count(); i++) {
        const ndl_preset *p = ndl_preset_at(i);
        nd_text_add(t, p->name);
        nd_text_add(t, p->is_metal ? ": metal, eta " : ": dielectric, ior ");
        if (p->is_metal) add_rgb(t, p->eta);
        else nd_text_float(t, p->eta[0]);
        if (p->is_metal) {
            nd_text_add(t, ", k ");
            add_rgb(t, p->k);
        }
        nd_text_add(t, "\n  ");
        cli_wrap(t, p->source, 2, 2);
        if (!p->file || !*p->file) continue;
        nd_text_add(t, "  from ");
        nd_text_add(t, p->file);
        nd_text_add(t, "\n");
    }
}

static void presets_json(nd_text *t) {
    nd_text_add(t, "{\"presets\":[");
    for (size_t i = 0; i < ndl_preset_count(); i++) {
        const ndl_preset *p = ndl_preset_at(i);
        nd_text_add(t, i ? ",\n{\"name\":" : "\n{\"name\":");
        nd_text_json(t, p->name);
        nd_text_add(t, p->is_metal ? ",\"kind\":\"metal\",\"eta\":"
                                   : ",\"kind\":\"dielectric\",\"ior\":");
        if (p->is_metal) add_rgb(t, p->eta);
        else nd_text_float(t, p->eta[0]);
        if (p->is_metal) {
            nd_text_add(t, ",\"k\":");
            add_rgb(t, p->k);
        }
        nd_text_add(t, ",\"source\":");
        nd_text_json(t, p->source);
        nd_text_add(t, ",\"file\":");
        nd_text_json(t, p->file ? p->file : "");
        nd_text_add(t, "}");
    }
    nd_text_add(t, "\n]}\n");
}

/* Names that a mistyped word may have meant: models, presets, words of choices, keys. */
static int nothing_found(const char *word) {
    char room[64];
    nd_nearest near = {.wanted = word};
    for (size_t i = 0; i < ndl_model_count(); i++) {
        size_t count;
        const ndl_param *p = ndl_model_params(i, &count);
        nd_nearest_offer(&near, ndl_model_name(i));
        for (size_t k = 0; k < count; k++) {
            nd_nearest_offer(&near, p[k].key);
            if (p[k].words) nd_nearest_words(&near, p[k].words, room, sizeof room);
        }
    }
    for (size_t i = 0; i < ndl_preset_count(); i++) nd_nearest_offer(&near, ndl_preset_at(i)->name);
    if (near.best)
        return cli_error("models", CLI_USAGE, cli_quote(word).s,
                         "no model, term or row of that name; did you mean '%s'?", near.best);
    return cli_error("models", CLI_USAGE, cli_quote(word).s,
                     "no model, term or row of that name; 'ndotl models' lists the models");
}

static int show(const char *word, bool json) {
    nd_text t = {0};
    int model = ndl_model_find(word);
    bool found = true;
    if (model >= 0 && json) cli_manual_json(&t, (size_t)model);
    else if (model >= 0) cli_manual(&t, (size_t)model);
    else found = json ? cli_find_json(&t, word) : cli_find(&t, word);
    if (found) return cli_put_text("models", &t);
    nd_text_free(&t);
    return nothing_found(word);
}

static int run(const cli_args *args) {
    bool json = cli_has(args, "--json"), wants_presets = cli_has(args, "--presets");
    if (args->operand_count && wants_presets)
        return cli_error("models", CLI_USAGE, "--presets", "takes no name; drop '%s'",
                         cli_quote(args->operands[0]).s);
    if (args->operand_count) return show(args->operands[0], json);
    nd_text t = {0};
    if (wants_presets && json) presets_json(&t);
    else if (wants_presets) presets(&t);
    else if (json) list_json(&t);
    else list(&t);
    return cli_put_text("models", &t);
}

const cli_command cli_models = {
    .name = "models",
    .summary = "the models, their manuals, terms and presets",
    .usage = "[NAME | TERM | ROW | --presets] [--json]",
    .details =
        "Without a name, lists the models. NAME prints the manual of a model: what it is, when to "
        "use it, its limits, its parameters with range, default, unit and feel, and the laws that "
        "it claims. TERM, such as smith or gold, finds the keys, words, presets and manuals that "
        "have it. ROW, such as S3.21, finds a row of the formula inventory (docs/formulas.md).\n",
    .example = "ndotl models ggx",
    .options = options,
    .least = 0,
    .most = 1,
    .operand = NULL,
    .run = run,
};
