/* SPDX-License-Identifier: Apache-2.0 */
/* Commands and their options as tables. One cli_command per verb (commands.def lists them) drives
   parsing, --help, the man page and the shell completions.

   A command gets its words parsed: run(const cli_args *) returns the exit code (report.h). */
#ifndef NDOTL_CLI_OPTIONS_H
#define NDOTL_CLI_OPTIONS_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *name;     /* "--term" or "-o" */
    const char *argument; /* placeholder, such as "FILE" or "T,P"; NULL for a flag */
    const char *words;    /* the only values allowed, separated by blanks; NULL: any text */
    bool repeats;         /* may be given more than once */
    const char *help;     /* one sentence without a full stop */
} cli_option;

typedef struct cli_args cli_args;

typedef struct {
    const char *name;     /* the verb */
    const char *summary;  /* one sentence without a full stop */
    const char *usage;    /* what follows "ndotl VERB" in the usage line; \n continues it */
    const char *details;  /* paragraphs for --help and the man page, each ended by \n */
    const char *example;  /* one command to type, or several lines */
    const cli_option *options; /* ended by a row with the name NULL */
    size_t least, most;   /* how many operands */
    const char *operand;  /* the first operand, for "MATERIAL: missing"; NULL when least is 0 */
    int (*run)(const cli_args *args);
} cli_command;

/* The words of a command line, sorted by cli_parse. */
struct cli_args {
    const cli_command *command;
    const char **operands;
    size_t operand_count;
    const cli_option **given; /* the row of each option given, in order */
    const char **values;      /* its value; NULL for a flag */
    size_t given_count;
};

/* All commands, in the order of commands.def; *count of them. */
const cli_command *const *cli_commands(size_t *count);

/* Sorts argv[0..argc) (without the verb) by the command's table. Accepts "--name value" and
   "--name=value"; "--" ends the options, "-" is an operand. 0, or 2 after a message. On success
   cli_free releases what *args holds. */
int cli_parse(const cli_command *command, int argc, char **argv, cli_args *args);
void cli_free(cli_args *args);

/* Whether an option was given; name as in the table. */
bool cli_has(const cli_args *args, const char *name);
/* The value of an option, or NULL when it was not given. */
const char *cli_value(const cli_args *args, const char *name);
/* Value number i of a repeated option, in the order given; NULL after the last. */
const char *cli_nth(const cli_args *args, const char *name, size_t i);

/* Readers of values: they leave *to alone when the option is missing. 0, or 2 after a message. */
/* A finite number in [low, high]. */
int cli_number(const cli_args *args, const char *name, double low, double high, double *to);
/* An integer in [low, high], |.| < 2^53. */
int cli_integer(const cli_args *args, const char *name, long long low, long long high,
                long long *to);
/* `count` finite numbers separated by commas, such as "30,90". */
int cli_numbers(const cli_args *args, const char *name, size_t count, double *to);
/* Two integers "WxH", each in [1, high]. */
int cli_size(const cli_args *args, const char *name, int high, int *width, int *height);

/* 2 after a message when both options are given, else 0. */
int cli_exclusive(const cli_args *args, const char *a, const char *b);

#endif
