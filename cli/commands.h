/* SPDX-License-Identifier: Apache-2.0 */
/* Declares every command of commands.def, and what main makes of their tables. */
#ifndef NDOTL_CLI_COMMANDS_H
#define NDOTL_CLI_COMMANDS_H
#include "base/text.h"
#include "options.h"

#define COMMAND(verb) extern const cli_command cli_##verb;
#include "commands.def"
#undef COMMAND

/* `ndotl --help` and `ndotl VERB --help`. */
void cli_help(nd_text *t);
void cli_command_help(nd_text *t, const cli_command *c);

/* `ndotl --man`: the manual page ndotl(1), in man macros. */
void cli_man(nd_text *t);

/* `ndotl --completion SHELL`; false for a shell that is neither bash nor zsh. */
bool cli_completion(nd_text *t, const char *shell);

#endif
