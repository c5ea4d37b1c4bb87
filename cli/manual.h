/* SPDX-License-Identifier: Apache-2.0 */
/* What `ndotl models` prints: the list, manuals, presets, and what a search finds. */
#ifndef NDOTL_CLI_MANUAL_H
#define NDOTL_CLI_MANUAL_H
#include "base/text.h"
#include "ndotl/ndotl.h"

#include <stdbool.h>
#include <stddef.h>

/* The heading of a section in lower case. */
typedef struct { char s[40]; } cli_heading_text;
cli_heading_text cli_heading(const ndl_manual *section);

/* The first sentence of what model i is. */
void cli_summary(nd_text *t, size_t model);

/* The manual of model i. */
void cli_manual(nd_text *t, size_t model);
void cli_manual_json(nd_text *t, size_t model);

/* Where a term stands: words of choices that contain it, keys, presets, sentences of manuals; for a
   row of the formula inventory such as S3.21 also the functions that compute it. False: nowhere. */
bool cli_find(nd_text *t, const char *term);
bool cli_find_json(nd_text *t, const char *term);

#endif
