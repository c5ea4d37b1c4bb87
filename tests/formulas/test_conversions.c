/* SPDX-License-Identifier: Apache-2.0 */
/* ndl_convert against the independent values of tests/golden/conversions.csv, within
   (16 + 4k) 2^-23 of the exact value. */
#include "../golden/golden_csv.h"

#include <math.h>
#include <ndotl/convert.h>

enum { TAG, GIVEN, TO, VALUE, K, CELLS, MOST_KNOWN = 8 };

/* "alpha=0.3 anisotropy_kind=gltf" as known quantities; the text is cut into pieces. */
static size_t known_of(char *text, ndl_known known[MOST_KNOWN]) {
    size_t count = 0;
    char *rest = text;
    for (char *pair = strtok_r(text, " ", &rest); pair && count < MOST_KNOWN;
         pair = strtok_r(NULL, " ", &rest)) {
        char *value = strchr(pair, '=');
        if (!value) return 0;
        *value++ = '\0';
        known[count].key = pair;
        known[count].word = ndl_convert_words(pair) ? value : NULL;
        known[count].value = known[count].word ? 0.0f : strtof(value, NULL);
        count++;
    }
    return count;
}

static bool agrees(golden_csv *row, double *worst) {
    ndl_known known[MOST_KNOWN] = {{NULL, 0.0f, NULL}};
    ndl_error err = {0};
    float got = 0.0f;
    if (row->cells != CELLS) {
        printf("conversions.csv:%d: %d cells\n", row->number, row->cells);
        return false;
    }
    size_t count = known_of(row->cell[GIVEN], known);
    if (ndl_convert(known, count, row->cell[TO], &got, &err) != NDL_OK) {
        printf("conversions.csv:%d (%s) to %s: %s\n", row->number, row->cell[TAG], row->cell[TO],
               err.text);
        return false;
    }
    double exact = golden_number(row, VALUE), k = golden_number(row, K);
    double error = fabs((double)got - exact);
    double bound = (16.0 + 4.0 * k) * 0x1p-23 * fabs(exact) + 1e-37;
    *worst = fmax(*worst, error / bound);
    if (error <= bound) return true;
    printf("conversions.csv:%d (%s) to %s: got %.9g, exact %.9g, %.3g of the bound\n", row->number,
           row->cell[TAG], row->cell[TO], (double)got, exact, error / bound);
    return false;
}

int main(void) {
    golden_csv row = golden_open("conversions");
    int rows = 0, failed = 0;
    double worst = 0.0;
    golden_next(&row); /* header */
    while (golden_next(&row)) {
        rows++;
        failed += !agrees(&row, &worst);
    }
    printf("%d conversions, worst %.3f of the bound, %d failed\n", rows, worst, failed);
    return rows > 0 && failed == 0 ? 0 : 1;
}
