/* SPDX-License-Identifier: Apache-2.0 */
/* test_energy.c with many more vectors of parameters. */
#define LAW_VECTORS 16
#include "test_energy.c"
