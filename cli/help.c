/* SPDX-License-Identifier: Apache-2.0 */
#include "commands.h"
#include "wrap.h"

#include <string.h>

static void option_line(nd_text *t, const char *name, const char *argument, const char *help) {
    enum { HELP_COLUMN = 24 };
    size_t n = 2 + strlen(name);
    nd_text_add(t, "  ");
    nd_text_add(t, name);
    if (argument) {
        nd_text_add(t, " ");
        nd_text_add(t, argument);
        n += 1 + strlen(argument);
    }
    if (n + 2 > HELP_COLUMN) nd_text_add(t, "\n");
    cli_spaces(t, n + 2 > HELP_COLUMN ? HELP_COLUMN : HELP_COLUMN - n);
    cli_wrap(t, help, HELP_COLUMN, HELP_COLUMN);
}

/* Each line of s indented by n. */
static void indented(nd_text *t, const char *s, size_t n) {
    while (*s) {
        size_t length = strcspn(s, "\n");
        cli_spaces(t, n);
        nd_text_bytes(t, s, length);
        nd_text_add(t, "\n");
        s += length + (s[length] == '\n');
    }
}

static void paragraphs(nd_text *t, const char *s) {
    while (*s) {
        size_t length = strcspn(s, "\n");
        char line[2048];
        if (length >= sizeof line) length = sizeof line - 1;
        memcpy(line, s, length);
        line[length] = '\0';
        nd_text_add(t, "\n");
        cli_wrap(t, line, 0, 0);
        s += length + (s[length] == '\n');
    }
}

void cli_command_help(nd_text *t, const cli_command *c) {
    nd_text_add(t, "ndotl ");
    nd_text_add(t, c->name);
    nd_text_add(t, ": ");
    nd_text_add(t, c->summary);
    nd_text_add(t, "\n\nusage: ndotl ");
    nd_text_add(t, c->name);
    nd_text_add(t, " ");
    for (const char *s = c->usage; *s; s++) {
        nd_text_bytes(t, s, 1);
        if (*s == '\n') cli_spaces(t, 7 + 6 + strlen(c->name) + 1);
    }
    nd_text_add(t, "\n");
    paragraphs(t, c->details);
    nd_text_add(t, "\noptions:\n");
    for (const cli_option *o = c->options; o->name; o++)
        option_line(t, o->name, o->argument, o->help);
    option_line(t, "--help", NULL, "this text");
    nd_text_add(t, "\nexample:\n");
    indented(t, c->example, 2);
}

void cli_help(nd_text *t) {
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    nd_text_add(t, "ndotl: reflectance models with numbers that can be trusted\n\n"
                   "usage: ndotl COMMAND [OPTIONS]\n\ncommands:\n");
    for (size_t i = 0; i < count; i++)
        option_line(t, commands[i]->name, NULL, commands[i]->summary);
    nd_text_add(t, "\noptions:\n");
    option_line(t, "--help", NULL, "this text; 'ndotl COMMAND --help' says more");
    option_line(t, "--version", NULL,
                "version, commit, instruction set, table and optional parts");
    option_line(t, "--completion", "bash|zsh", "a completion script for that shell");
    option_line(t, "--man", NULL, "the manual page, for 'man -l -'");
    nd_text_add(t, "\nenvironment:\n");
    option_line(t, "NDOTL_ISA", NULL,
                "instruction set: scalar x86-64 x86-64-v3 x86-64-v4 neon; empty: the best");
    option_line(t, "NDOTL_TABLE", NULL, "table of kernels: exact; empty: exact");
    nd_text_add(t, "\nexample:\n"
                   "  echo '0 0.6 0.8  0 -0.6 0.8' | ndotl eval 'ggx(preset=gold, roughness=0.3)'\n"
                   "\nexit codes: 0 success, 1 a file or stream, 2 the command line or an "
                   "expression\n");
}
