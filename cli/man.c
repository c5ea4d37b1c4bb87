/* SPDX-License-Identifier: Apache-2.0 */
/* The manual page, from the tables of the commands. */
#include "commands.h"

#include "ndotl/ndotl.h"

/* Text with what roff would take as its own written safely; every line of s begins a new one, with
   `between` before all but the first. */
static void roff(nd_text *t, const char *s, const char *between) {
    bool line_start = true;
    for (; *s; s++) {
        if (*s == '\n') {
            if (s[1]) nd_text_add(t, between);
            line_start = true;
            continue;
        }
        if (line_start && *s == '.') nd_text_add(t, "\\&");
        line_start = false;
        if (*s == '\\') nd_text_add(t, "\\e");
        else if (*s == '-') nd_text_add(t, "\\-");
        else if (*s == '\'') nd_text_add(t, "\\(aq");
        else nd_text_bytes(t, s, 1);
    }
}

static void styled(nd_text *t, const char *style, const char *s) {
    nd_text_add(t, style);
    roff(t, s, "\n");
    nd_text_add(t, "\\fR");
}

static void option(nd_text *t, const char *name, const char *argument, const char *help) {
    nd_text_add(t, ".TP\n");
    styled(t, "\\fB", name);
    if (argument) {
        nd_text_add(t, " ");
        styled(t, "\\fI", argument);
    }
    nd_text_add(t, "\n");
    roff(t, help, "\n");
    nd_text_add(t, "\n");
}

static void verbatim(nd_text *t, const char *s) {
    nd_text_add(t, ".PP\n.RS\n.nf\n");
    roff(t, s, "\n");
    nd_text_add(t, "\n.fi\n.RE\n");
}

static void command(nd_text *t, const cli_command *c) {
    nd_text_add(t, ".SS ");
    roff(t, c->name, "\n");
    nd_text_add(t, "\n");
    roff(t, c->summary, "\n");
    nd_text_add(t, ".\n.PP\n.nf\n");
    styled(t, "\\fB", "ndotl ");
    styled(t, "\\fB", c->name);
    nd_text_add(t, " ");
    roff(t, c->usage, "\n    ");
    nd_text_add(t, "\n.fi\n.PP\n");
    roff(t, c->details, "\n.PP\n");
    nd_text_add(t, "\n");
    for (const cli_option *o = c->options; o->name; o++) option(t, o->name, o->argument, o->help);
    verbatim(t, c->example);
}

void cli_man(nd_text *t) {
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    nd_text_add(t, ".TH NDOTL 1 \"\" \"ndotl ");
    nd_text_add(t, ndl_version());
    nd_text_add(t, "\" \"User Commands\"\n.SH NAME\n"
                   "ndotl \\- reflectance models with numbers that can be trusted\n"
                   ".SH SYNOPSIS\n.B ndotl\n.I command\n[\\fIoptions\\fR]\n"
                   ".SH DESCRIPTION\n");
    roff(t,
         "Evaluates, describes and renders reflectance models (BRDFs).\n"
         "Local frame: n = (0,0,1), t = (1,0,0); wi points to the light, wo to the viewer, both "
         "are unit vectors that leave the surface. A value is 0 unless wi.z > 0 and wo.z > 0. "
         "Angles are radians unless a name says _deg; colours are linear Rec.709.\n"
         "A material is a weighted sum of models: '0.3*lambert(color=0.8) + "
         "0.7*ggx(preset=gold, roughness=0.3)', or the JSON long form of it.\n",
         "\n.PP\n");
    nd_text_add(t, "\n.SH COMMANDS\n");
    for (size_t i = 0; i < count; i++) command(t, commands[i]);
    nd_text_add(t, ".SH OPTIONS\n");
    option(t, "--help", NULL, "Help; after a command, that command's.");
    option(t, "--version", NULL, "Version, commit, instruction set, table and optional parts.");
    option(t, "--completion", "bash|zsh", "A completion script for that shell.");
    option(t, "--man", NULL, "This page.");
    nd_text_add(t, ".SH ENVIRONMENT\n");
    option(t, "NDOTL_ISA", NULL,
           "Instruction set: scalar, x86-64, x86-64-v3, x86-64-v4, neon. Empty: the best.");
    option(t, "NDOTL_TABLE", NULL, "Table of kernels: exact. Empty: exact.");
    nd_text_add(t, ".SH EXIT STATUS\n");
    option(t, "0", NULL, "Success.");
    option(t, "1", NULL, "A file or stream is missing, unreadable, malformed or unwritable.");
    option(t, "2", NULL, "The command line or an expression is wrong; nothing is on stdout.");
}
