/* SPDX-License-Identifier: Apache-2.0 */
#include "base/number.h"
#include "ndotl/convert.h"
#include "number_text.h"
#include "options.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const cli_option options[] = {
    {"--to", "KEY[,KEY...]", NULL, false, "what to derive; one line each"},
    {"--json", NULL, NULL, false, "write an object of the derived values"},
    {NULL, NULL, NULL, false, NULL},
};

enum { LONGEST = 63 };

/* Reads KEY=VALUE; *key receives the key, terminated. 0, or 2 after a message. */
static int read_known(const char *word, char key[LONGEST + 1], ndl_known *to) {
    size_t n = strcspn(word, "=");
    if (!n || n > LONGEST || !word[n])
        return cli_error("param", CLI_USAGE, cli_quote(word).s,
                         "expected KEY=VALUE, as in roughness=0.5");
    memcpy(key, word, n);
    key[n] = '\0';
    const char *value = word + n + 1;
    *to = (ndl_known){.key = key};
    if (ndl_convert_words(key)) {
        to->word = value;
        return CLI_OK;
    }
    size_t used = nd_parse_float(value, strlen(value), &to->value);
    if (!used || value[used] || !isfinite(to->value))
        return cli_error("param", CLI_USAGE, cli_quote(word).s, "'%s' is not a finite number",
                         cli_quote(value).s);
    return CLI_OK;
}

static void add_value(nd_text *t, bool json, bool first, const char *key, float value) {
    char digits[CLI_PRINT_ROOM];
    size_t n = cli_print_float(value, digits);
    if (json) {
        nd_text_add(t, first ? "{" : ",");
        nd_text_json(t, key);
        nd_text_add(t, ":");
    } else {
        nd_text_add(t, key);
        nd_text_add(t, "=");
    }
    nd_text_bytes(t, digits, n);
    if (!json) nd_text_add(t, "\n");
}

/* Converts to each key of the list; results go to t. */
static int convert_all(const char *list, const ndl_known *known, size_t count, bool json,
                       nd_text *t) {
    for (const char *s = list;; s++) {
        char key[LONGEST + 1];
        ndl_error error = {0};
        float value = 0.0f;
        size_t n = strcspn(s, ",");
        if (!n || n > LONGEST)
            return cli_error("param", CLI_USAGE, "--to", "'%s' is not a list of keys",
                             cli_quote(list).s);
        memcpy(key, s, n);
        key[n] = '\0';
        if (ndl_convert(known, count, key, &value, &error) != NDL_OK)
            return cli_error("param", CLI_USAGE, NULL, "%s", error.text);
        add_value(t, json, s == list, key, value);
        s += n;
        if (!*s) break;
    }
    if (json) nd_text_add(t, "}\n");
    return CLI_OK;
}

static int run(const cli_args *args) {
    size_t count = args->operand_count;
    const char *list = cli_value(args, "--to");
    if (!list) return cli_error("param", CLI_USAGE, "--to", "missing; say what to derive");
    char(*keys)[LONGEST + 1] = calloc(count, sizeof *keys);
    ndl_known *known = calloc(count, sizeof *known);
    nd_text t = {0};
    int code = keys && known ? CLI_OK : cli_error("param", CLI_FAILED, NULL, "out of memory");
    for (size_t i = 0; !code && i < count; i++)
        code = read_known(args->operands[i], keys[i], &known[i]);
    if (!code) code = convert_all(list, known, count, cli_has(args, "--json"), &t);
    if (!code) code = cli_put_text("param", &t);
    nd_text_free(&t);
    free(keys);
    free(known);
    return code;
}

const cli_command cli_param = {
    .name = "param",
    .summary = "conversions between parameters that mean one thing",
    .usage = "KEY=VALUE... --to KEY[,KEY...] [--json]",
    .details =
        "Keys: alpha, alpha_x, alpha_y, roughness, anisotropy, blinn_exponent, phong_exponent; "
        "ior, f0; sigma, sigma_deg, a, a57. roughness_map=square|direct|sqrt says what roughness "
        "means, anisotropy_kind=burley|kulla|openpbr|gltf what anisotropy does.\n"
        "Prints a line KEY=VALUE for each key of --to, with nine significant digits.\n",
    .example = "ndotl param roughness=0.5 --to alpha,blinn_exponent",
    .options = options,
    .least = 1,
    .most = 64,
    .operand = "KEY=VALUE",
    .run = run,
};
