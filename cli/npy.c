/* SPDX-License-Identifier: Apache-2.0 */
#include "npy.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const char magic[] = "\x93NUMPY";

bool cli_npy_begins(const char *s, size_t n) {
    return n && memcmp(s, magic, n < CLI_NPY_MAGIC ? n : CLI_NPY_MAGIC) == 0;
}

static uint64_t little_endian(const unsigned char *s, size_t n) {
    uint64_t x = 0;
    while (n--) x = x << 8 | s[n];
    return x;
}

/* The text behind 'key': in the header's dictionary, or NULL. */
static const char *entry(const char *header, const char *key) {
    const char *at = strstr(header, key);
    if (!at) return NULL;
    at += strlen(key);
    at += strspn(at, " ");
    if (*at++ != ':') return NULL;
    return at + strspn(at, " ");
}

/* The extents of "(3, 4, )": how many, at most `most`; -1 where it is no shape. */
static int read_shape(const char *s, size_t *extent, int most) {
    int n = 0;
    if (*s++ != '(') return -1;
    for (s += strspn(s, " "); *s != ')'; s += strspn(s, ", ")) {
        size_t x = 0, digits = strspn(s, "0123456789");
        if (!digits || digits > 15 || n == most) return -1;
        for (size_t i = 0; i < digits; i++) x = 10 * x + (size_t)(s[i] - '0');
        extent[n++] = x;
        s += digits;
        if (*s == 'L') s++; /* written by Python 2 */
    }
    return n;
}

static const char *use_shape(const char *s, size_t columns, cli_npy *a) {
    size_t extent[3] = {1, 1, 1};
    int n = s ? read_shape(s, extent, 3) : -1;
    if (n == 1 && extent[0] == columns) {
        a->rows = 1;
    } else if (n == 2 && extent[1] == columns) {
        a->rows = extent[0];
    } else if (n == 3 && !a->by_columns && extent[1] < 100 && extent[2] < 100 &&
               extent[1] * extent[2] == columns) {
        a->rows = extent[0];
    } else {
        return columns == 6 ? "the array's shape must be (rows, 6): wi.x wi.y wi.z wo.x wo.y wo.z"
                            : "the array's shape must be (rows, 4): theta_i phi_i theta_o phi_o";
    }
    a->columns = columns;
    return NULL;
}

static const char *use_header(const char *header, size_t columns, cli_npy *a) {
    const char *type = entry(header, "'descr'"), *order = entry(header, "'fortran_order'");
    if (!type || !order) return "the .npy header is malformed";
    a->by_columns = strncmp(order, "True", 4) == 0;
    if (strncmp(type, "'<f4'", 5) == 0) a->item = 4;
    else if (strncmp(type, "'<f8'", 5) == 0) a->item = 8;
    else return "the array's type must be float32 or float64; convert it with .astype('<f4')";
    return use_shape(entry(header, "'shape'"), columns, a);
}

const char *cli_npy_view(const char *s, size_t n, size_t columns, cli_npy *a) {
    const unsigned char *bytes = (const unsigned char *)s;
    static const char cut[] = "the .npy header is cut off";
    char header[2048];
    if (n < 10) return cut;
    size_t before = bytes[6] == 1 ? 10 : 12;
    if (n < before) return cut;
    size_t length = (size_t)little_endian(bytes + 8, before - 8);
    if (length >= sizeof header) return "the .npy header is too long";
    if (n - before < length) return cut;
    memcpy(header, s + before, length);
    header[length] = '\0';
    const char *wrong = use_header(header, columns, a);
    if (wrong) return wrong;
    a->data = bytes + before + length;
    if ((n - before - length) / (a->item * columns) < a->rows)
        return "the array is cut off: its data ends before its shape says so";
    return NULL;
}

double cli_npy_value(const cli_npy *a, size_t row, size_t column) {
    size_t i = a->by_columns ? column * a->rows + row : row * a->columns + column;
    uint64_t bits = little_endian(a->data + i * a->item, a->item);
    if (a->item == 8) {
        double x;
        memcpy(&x, &bits, sizeof x);
        return x;
    }
    uint32_t half = (uint32_t)bits;
    float x;
    memcpy(&x, &half, sizeof x);
    return (double)x;
}

void cli_npy_header(size_t rows, size_t columns, char to[CLI_NPY_HEADER]) {
    char text[CLI_NPY_HEADER];
    int n = columns == 1
                ? snprintf(text, sizeof text,
                           "{'descr': '<f4', 'fortran_order': False, 'shape': (%zu,), }", rows)
                : snprintf(text, sizeof text,
                           "{'descr': '<f4', 'fortran_order': False, 'shape': (%zu, %zu), }", rows,
                           columns);
    memset(to, ' ', CLI_NPY_HEADER);
    memcpy(to, magic, CLI_NPY_MAGIC);
    memcpy(to + CLI_NPY_MAGIC, (const char[]){1, 0, CLI_NPY_HEADER - 10, 0}, 4);
    memcpy(to + 10, text, (size_t)n);
    to[CLI_NPY_HEADER - 1] = '\n';
}
