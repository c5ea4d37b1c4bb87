/* SPDX-License-Identifier: Apache-2.0 */
#include "material.h"

#include "report.h"

#include <string.h>
#if NDL_WORKBENCH
#include "io/json_material.h"
#endif

int cli_material(const char *verb, const char *what, const char *text, ndl_material **to) {
    ndl_error error = {0};
    const char *first = text + strspn(text, " \t\r\n");
    if (*first == '{') {
#if NDL_WORKBENCH
        *to = nd_json_material(text, &error);
#else
        return cli_error(verb, CLI_USAGE, what,
                         "this build reads no JSON; write the material in short form");
#endif
    } else {
        *to = ndl_material_parse(text, &error);
    }
    return *to ? CLI_OK : cli_expression_error(verb, what, &error);
}
