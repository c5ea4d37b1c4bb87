/* SPDX-License-Identifier: Apache-2.0 */
/* test_values.c with many more pairs of directions. */
#define LAW_PAIRS 30000000
#include "test_values.c"
