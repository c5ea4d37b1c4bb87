/* SPDX-License-Identifier: Apache-2.0 */
/* test_batches.c with more than a million pairs for each kernel. */
#define LAW_PAIRS 1100000
#include "test_batches.c"
