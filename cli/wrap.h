/* SPDX-License-Identifier: Apache-2.0 */
/* Prose for a terminal of 80 columns. */
#ifndef NDOTL_CLI_WRAP_H
#define NDOTL_CLI_WRAP_H
#include "base/text.h"

#include <stddef.h>

void cli_spaces(nd_text *t, size_t n);

/* The words of s from column `at` on, broken before column 80, later lines indented by `indent`;
   ends the line. */
void cli_wrap(nd_text *t, const char *s, size_t at, size_t indent);

#endif
