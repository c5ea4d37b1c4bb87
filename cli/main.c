/* SPDX-License-Identifier: Apache-2.0 */
#include "base/nearest.h"
#include "base/stream.h"
#include "commands.h"
#include "nd_build.h"
#include "ndotl/ndotl.h"
#include "report.h"

#include <string.h>

static int print(void (*writer)(nd_text *)) {
    nd_text t = {0};
    writer(&t);
    return cli_put_text("", &t);
}

static void three_commands(nd_text *t) {
    nd_text_add(t, "Three commands to try ('ndotl --help' lists all):\n"
                   "  ndotl models ggx\n"
                   "  echo '0 0.6 0.8  0 -0.6 0.8' | ndotl eval 'ggx(preset=gold, roughness=0.3)'\n"
#if NDL_WORKBENCH
                   "  ndotl render 'ggx(preset=gold, roughness=0.3)' --mesh shaderball "
                   "--size 480x480 -o gold.png\n");
#else
                   "  ndotl param roughness=0.5 --to alpha,blinn_exponent\n");
#endif
}

static void version(nd_text *t) {
    nd_text_add(t, "ndotl " NDL_BUILD_VERSION "\n"
                   "commit: " NDL_BUILD_COMMIT "\n"
                   "instruction set: ");
    nd_text_add(t, ndl_isa());
    nd_text_add(t, "\ntable: exact\noptional parts: ");
#if NDL_WORKBENCH
    nd_text_add(t, "workbench (render, JSON materials)\n");
#else
    nd_text_add(t, "none (the workbench is left out)\n");
#endif
}

static int print_version(void) {
    int code = cli_use_environment("");
    return code ? code : print(version);
}

static int completion(const char *shell) {
    nd_text t = {0};
    if (!shell || !cli_completion(&t, shell))
        return cli_error("", CLI_USAGE, "--completion", "name a shell: bash or zsh");
    return cli_put_text("", &t);
}

static int unknown_command(const char *word) {
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    nd_nearest near = {.wanted = word};
    for (size_t i = 0; i < count; i++) nd_nearest_offer(&near, commands[i]->name);
    static const char *const options[] = {"--help", "--version", "--completion", "--man"};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        nd_nearest_offer(&near, options[i]);
    const char *kind = word[0] == '-' ? "option" : "command";
    if (near.best)
        return cli_error("", CLI_USAGE, cli_quote(word).s, "unknown %s; did you mean '%s'?", kind,
                         near.best);
    return cli_error("", CLI_USAGE, cli_quote(word).s, "unknown %s; see 'ndotl --help'", kind);
}

static bool asks_for_help(int argc, char **argv) {
    for (int i = 0; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) return true;
    return false;
}

static int run(const cli_command *c, int argc, char **argv) {
    if (asks_for_help(argc, argv)) {
        nd_text t = {0};
        cli_command_help(&t, c);
        return cli_put_text(c->name, &t);
    }
    cli_args args;
    int code = cli_parse(c, argc, argv, &args);
    if (code) return code;
    code = c->run(&args);
    cli_free(&args);
    return code;
}

int main(int argc, char **argv) {
    nd_stream_survive_closed_pipes();
    if (argc < 2) return print(three_commands);
    const char *word = argv[1];
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) return print(cli_help);
    if (strcmp(word, "--version") == 0) return print_version();
    if (strcmp(word, "--man") == 0) return print(cli_man);
    if (strcmp(word, "--completion") == 0) return completion(argc > 2 ? argv[2] : NULL);
    size_t count;
    const cli_command *const *commands = cli_commands(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(commands[i]->name, word) == 0) return run(commands[i], argc - 2, argv + 2);
    return unknown_command(word);
}
