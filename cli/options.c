/* SPDX-License-Identifier: Apache-2.0 */
#include "options.h"

#include "base/nearest.h"
#include "base/number.h"
#include "commands.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COMMAND(verb) &cli_##verb,
static const cli_command *const all[] = {
#include "commands.def"
};
#undef COMMAND

const cli_command *const *cli_commands(size_t *count) {
    *count = sizeof all / sizeof *all;
    return all;
}

static const cli_option *find(const cli_command *c, const char *name, size_t n) {
    for (const cli_option *o = c->options; o->name; o++)
        if (strlen(o->name) == n && memcmp(o->name, name, n) == 0) return o;
    return NULL;
}

static int unknown_option(const cli_command *c, const char *word, size_t n) {
    char name[64];
    if (n >= sizeof name) n = sizeof name - 1;
    memcpy(name, word, n);
    name[n] = '\0';
    nd_nearest near = {.wanted = name};
    for (const cli_option *o = c->options; o->name; o++) nd_nearest_offer(&near, o->name);
    nd_nearest_offer(&near, "--help");
    cli_quoted place = cli_quote(name);
    if (near.best)
        return cli_error(c->name, CLI_USAGE, place.s, "unknown option; did you mean '%s'?",
                         near.best);
    return cli_error(c->name, CLI_USAGE, place.s, "unknown option; see 'ndotl %s --help'",
                     c->name);
}

static bool is_word(const char *words, const char *word) {
    size_t n = strlen(word);
    while (n && *words) {
        size_t length = strcspn(words, " ");
        if (length == n && memcmp(words, word, n) == 0) return true;
        words += length + (words[length] == ' ');
    }
    return false;
}

static int bad_word(const cli_command *c, const cli_option *o, const char *value) {
    char room[64];
    nd_nearest near = {.wanted = value};
    if (strlen(value) > 2) nd_nearest_words(&near, o->words, room, sizeof room);
    if (near.best)
        return cli_error(c->name, CLI_USAGE, o->name, "unknown word '%s'; did you mean '%s'?",
                         cli_quote(value).s, near.best);
    return cli_error(c->name, CLI_USAGE, o->name, "unknown word '%s'; use one of: %s",
                     cli_quote(value).s, o->words);
}

/* Records one option; *at is the index of its word, moved on when the value is the next one. */
static int take_option(cli_args *args, int argc, char **argv, int *at) {
    const cli_command *c = args->command;
    const char *word = argv[*at], *value = NULL;
    size_t n = strncmp(word, "--", 2) == 0 ? strcspn(word, "=") : strlen(word);
    const cli_option *o = find(c, word, n);
    if (!o) return unknown_option(c, word, n);
    if (word[n] == '=') value = word + n + 1;
    if (value && !o->argument)
        return cli_error(c->name, CLI_USAGE, o->name, "takes no value; drop '=%s'",
                         cli_quote(value).s);
    if (o->argument && !value) {
        const char *next = *at + 1 < argc ? argv[*at + 1] : NULL;
        if (!next || strncmp(next, "--", 2) == 0)
            return cli_error(c->name, CLI_USAGE, o->name, "needs a value; give %s %s", o->name,
                             o->argument);
        value = next;
        ++*at;
    }
    if (!o->repeats && cli_has(args, o->name))
        return cli_error(c->name, CLI_USAGE, o->name, "given twice; keep one");
    if (o->words && !is_word(o->words, value)) return bad_word(c, o, value);
    args->given[args->given_count] = o;
    args->values[args->given_count++] = value;
    return CLI_OK;
}

/* "-" and a negative number, as in "-1*lambert", are no options. */
static bool is_operand(const char *word) {
    return word[0] != '-' || word[1] == '\0' || strchr(".0123456789", word[1]);
}

static int sort_words(cli_args *args, int argc, char **argv) {
    bool only_operands = false;
    for (int i = 0; i < argc; i++) {
        if (only_operands || is_operand(argv[i])) {
            args->operands[args->operand_count++] = argv[i];
        } else if (strcmp(argv[i], "--") == 0) {
            only_operands = true;
        } else {
            int code = take_option(args, argc, argv, &i);
            if (code) return code;
        }
    }
    const cli_command *c = args->command;
    if (args->operand_count < c->least)
        return cli_error(c->name, CLI_USAGE, c->operand, "missing; see 'ndotl %s --help'", c->name);
    if (args->operand_count > c->most)
        return cli_error(c->name, CLI_USAGE, cli_quote(args->operands[c->most]).s,
                         "unexpected; %s takes at most %d operand%s", c->name, (int)c->most,
                         c->most == 1 ? "" : "s");
    return CLI_OK;
}

int cli_parse(const cli_command *command, int argc, char **argv, cli_args *args) {
    size_t n = argc > 0 ? (size_t)argc : 0;
    *args = (cli_args){.command = command};
    args->operands = calloc(n + 1, sizeof *args->operands);
    args->given = calloc(n + 1, sizeof *args->given);
    args->values = calloc(n + 1, sizeof *args->values);
    int code = args->operands && args->given && args->values
                   ? sort_words(args, argc, argv)
                   : cli_error(command->name, CLI_FAILED, NULL, "out of memory");
    if (code) cli_free(args);
    return code;
}

void cli_free(cli_args *args) {
    free(args->operands);
    free(args->given);
    free(args->values);
    *args = (cli_args){0};
}

const char *cli_nth(const cli_args *args, const char *name, size_t i) {
    for (size_t k = 0; k < args->given_count; k++)
        if (strcmp(args->given[k]->name, name) == 0 && i-- == 0)
            return args->values[k] ? args->values[k] : "";
    return NULL;
}

const char *cli_value(const cli_args *args, const char *name) {
    return cli_nth(args, name, 0);
}

bool cli_has(const cli_args *args, const char *name) {
    return cli_value(args, name) != NULL;
}

int cli_exclusive(const cli_args *args, const char *a, const char *b) {
    if (!cli_has(args, a) || !cli_has(args, b)) return CLI_OK;
    return cli_error(args->command->name, CLI_USAGE, b, "excludes %s; keep one", a);
}

/* One number that ends at `end`; the bytes used, 0 where none begins. */
static size_t read_number(const char *s, double *to) {
    size_t used = nd_parse_double(s, strlen(s), to);
    return used && isfinite(*to) ? used : 0;
}

int cli_number(const cli_args *args, const char *name, double low, double high, double *to) {
    const char *s = cli_value(args, name);
    double x;
    if (!s) return CLI_OK;
    size_t used = read_number(s, &x);
    if (!used || s[used])
        return cli_error(args->command->name, CLI_USAGE, name, "'%s' is not a finite number",
                         cli_quote(s).s);
    if (x < low || x > high)
        return cli_error(args->command->name, CLI_USAGE, name, "%s is out of range; use %g to %g",
                         cli_quote(s).s, low, high);
    *to = x;
    return CLI_OK;
}

int cli_integer(const cli_args *args, const char *name, long long low, long long high,
                long long *to) {
    const char *s = cli_value(args, name);
    if (!s) return CLI_OK;
    size_t at = s[0] == '-' || s[0] == '+', digits = strspn(s + at, "0123456789");
    if (!digits || s[at + digits])
        return cli_error(args->command->name, CLI_USAGE, name, "'%s' is not an integer",
                         cli_quote(s).s);
    double x = 0.0;
    nd_parse_double(s, at + digits, &x);
    if (x < (double)low || x > (double)high)
        return cli_error(args->command->name, CLI_USAGE, name,
                         "%s is out of range; use %lld to %lld", cli_quote(s).s, low, high);
    *to = (long long)x;
    return CLI_OK;
}

int cli_numbers(const cli_args *args, const char *name, size_t count, double *to) {
    const char *s = cli_value(args, name);
    if (!s) return CLI_OK;
    size_t at = 0, found = 0;
    for (; found < count; found++) {
        size_t used = read_number(s + at, &to[found]);
        if (!used) break;
        at += used;
        if (found + 1 < count && s[at++] != ',') break;
    }
    if (found < count || s[at])
        return cli_error(args->command->name, CLI_USAGE, name,
                         "'%s' is not a list of %d finite numbers separated by commas",
                         cli_quote(s).s, (int)count);
    return CLI_OK;
}

static const char *read_extent(const char *s, int high, int *to) {
    size_t digits = strspn(s, "0123456789");
    double x = 0.0;
    if (!digits || !nd_parse_double(s, digits, &x) || x < 1.0 || x > (double)high) return NULL;
    *to = (int)x;
    return s + digits;
}

int cli_size(const cli_args *args, const char *name, int high, int *width, int *height) {
    const char *s = cli_value(args, name);
    if (!s) return CLI_OK;
    int w, h;
    const char *rest = read_extent(s, high, &w);
    if (rest && *rest == 'x') rest = read_extent(rest + 1, high, &h);
    else rest = NULL;
    if (!rest || *rest)
        return cli_error(args->command->name, CLI_USAGE, name,
                         "'%s' is not a size; write WxH, each from 1 to %d, as in 640x480",
                         cli_quote(s).s, high);
    *width = w;
    *height = h;
    return CLI_OK;
}
