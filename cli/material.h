/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NDOTL_CLI_MATERIAL_H
#define NDOTL_CLI_MATERIAL_H
#include "ndotl/ndotl.h"

/* The material that a word of the command line describes, in short form or JSON long form.
   0 and *to, which the caller frees; or an exit code after a message. `what` as in
   cli_expression_error. */
int cli_material(const char *verb, const char *what, const char *text, ndl_material **to);

#endif
