/* SPDX-License-Identifier: Apache-2.0 */
/* test_continuity.c with many more vectors of parameters. */
#define LAW_VECTORS 256
#include "test_continuity.c"
