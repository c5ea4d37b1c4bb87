/* SPDX-License-Identifier: Apache-2.0 */
/* test_reciprocity.c with many more pairs of directions. */
#define LAW_PAIRS 20000000
#include "test_reciprocity.c"
