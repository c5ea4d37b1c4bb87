/* SPDX-License-Identifier: Apache-2.0 */
#ifndef ND_CORE_PRINT_H
#define ND_CORE_PRINT_H
#include "core/material.h"

/* A bound material as canonical short form and as JSON long form: keys in the order of the
   parameter table, numbers at their shortest. Owned by the caller; NULL when memory is out. */
char *nd_print_text(const ndl_material *m);
char *nd_print_json(const ndl_material *m);

#endif
