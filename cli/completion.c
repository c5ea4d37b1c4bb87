/* SPDX-License-Identifier: Apache-2.0 */
/* Completion scripts for bash and zsh, from the tables of the commands. */
#include "commands.h"

#include "ndotl/ndotl.h"

#include <string.h>

static void add_models(nd_text *t) {
    for (size_t i = 0; i < ndl_model_count(); i++) {
        if (i) nd_text_add(t, " ");
        nd_text_add(t, ndl_model_name(i));
    }
}

/* Cases that set `words` for the value of an option; files where any text is allowed. */
static void bash_values(nd_text *t, const cli_command *c) {
    for (const cli_option *o = c->options; o->name; o++) {
        if (!o->argument) continue;
        nd_text_add(t, "        ");
        nd_text_add(t, c->name);
        nd_text_add(t, ":");
        nd_text_add(t, o->name);
        nd_text_add(t, ") words='");
        nd_text_add(t, o->words ? o->words : "");
        nd_text_add(t, "' ;;\n");
    }
}

static void bash_options(nd_text *t, const cli_command *c) {
    nd_text_add(t, "        ");
    nd_text_add(t, c->name);
    nd_text_add(t, ":*) words='--help");
    for (const cli_option *o = c->options; o->name; o++) {
        nd_text_add(t, " ");
        nd_text_add(t, o->name);
    }
    nd_text_add(t, "'\n            [[ $current == -* ]] || words='");
    add_models(t);
    nd_text_add(t, "' ;;\n");
}

static void bash(nd_text *t) {
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    nd_text_add(t, "# bash completion for ndotl, made by 'ndotl --completion bash'\n"
                   "_ndotl() {\n"
                   "    local current=${COMP_WORDS[COMP_CWORD]}"
                   " before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
                   "    case ${COMP_WORDS[1]}:$before in\n"
                   "        *:--completion) words='bash zsh' ;;\n"
                   "        *:ndotl|*:*/ndotl) words='--help --version --completion --man");
    for (size_t i = 0; i < count; i++) {
        nd_text_add(t, " ");
        nd_text_add(t, commands[i]->name);
    }
    nd_text_add(t, "' ;;\n");
    for (size_t i = 0; i < count; i++) {
        bash_values(t, commands[i]);
        bash_options(t, commands[i]);
    }
    nd_text_add(t, "    esac\n"
                   "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
                   "}\n"
                   "complete -o default -F _ndotl ndotl\n");
}

/* A zsh _arguments specification: '--name=[help]:argument:(words)'. */
static void zsh_option(nd_text *t, const cli_option *o) {
    nd_text_add(t, " \\\n            '");
    if (o->repeats) nd_text_add(t, "*");
    nd_text_add(t, o->name);
    nd_text_add(t, "[");
    for (const char *s = o->help; *s; s++) {
        if (strchr("[]:", *s)) nd_text_add(t, "\\");
        if (*s == '\'') nd_text_add(t, "'\\'");
        nd_text_bytes(t, s, 1);
    }
    nd_text_add(t, "]");
    if (o->argument) {
        nd_text_add(t, ":value:");
        if (o->words) nd_text_add(t, "(");
        nd_text_add(t, o->words ? o->words : "_files");
        if (o->words) nd_text_add(t, ")");
    }
    nd_text_add(t, "'");
}

static void zsh(nd_text *t) {
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    nd_text_add(t, "#compdef ndotl\n# zsh completion for ndotl, made by 'ndotl --completion zsh'\n"
                   "_ndotl() {\n"
                   "    if ((CURRENT == 2)); then\n"
                   "        compadd -- --help --version --completion --man");
    for (size_t i = 0; i < count; i++) {
        nd_text_add(t, " ");
        nd_text_add(t, commands[i]->name);
    }
    nd_text_add(t, "\n        return\n    fi\n"
                   "    local verb=$words[2]\n"
                   "    shift words\n    ((CURRENT--))\n"
                   "    case $verb in\n"
                   "        --completion) compadd bash zsh ;;\n");
    for (size_t i = 0; i < count; i++) {
        nd_text_add(t, "        ");
        nd_text_add(t, commands[i]->name);
        nd_text_add(t, ") _arguments '--help[help]'");
        for (const cli_option *o = commands[i]->options; o->name; o++) zsh_option(t, o);
        nd_text_add(t, " \\\n            '1::model:(");
        add_models(t);
        nd_text_add(t, ")' '*::file:_files' ;;\n");
    }
    nd_text_add(t, "    esac\n}\n"
                   "if [ \"$funcstack[1]\" = _ndotl ]; then _ndotl \"$@\"; "
                   "else compdef _ndotl ndotl; fi\n");
}

bool cli_completion(nd_text *t, const char *shell) {
    if (strcmp(shell, "bash") == 0) bash(t);
    else if (strcmp(shell, "zsh") == 0) zsh(t);
    else return false;
    return true;
}
