/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LEFT = 470, RIGHT = 860, WIDTH = 960, TOP = 56, ROW = 20, LONGEST_LABEL = 64 };

static void add(nd_text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void add(nd_text *t, const char *format, ...) {
    char line[400];
    va_list values;
    va_start(values, format);
    vsnprintf(line, sizeof line, format, values);
    va_end(values);
    nd_text_add(t, line);
}

/* Text of an element; what is too long for its column ends in three dots. */
static void add_escaped(nd_text *t, const char *s) {
    size_t n = strlen(s), shown = n > LONGEST_LABEL ? LONGEST_LABEL - 3 : n;
    for (size_t i = 0; i < shown; i++) {
        if (s[i] == '&')
            nd_text_add(t, "&amp;");
        else if (s[i] == '<')
            nd_text_add(t, "&lt;");
        else if (s[i] == '>')
            nd_text_add(t, "&gt;");
        else
            nd_text_bytes(t, s + i, 1);
    }
    if (shown < n) nd_text_add(t, "...");
}

/* The smallest of 1, 2, 5 times a power of ten that is a quarter of `most` or more. */
static double step_of(double most) {
    double power = pow(10.0, floor(log10(most / 4.0)));
    double times = most / 4.0 / power;
    return power * (times <= 1.0 ? 1.0 : times <= 2.0 ? 2.0 : times <= 5.0 ? 5.0 : 10.0);
}

static void add_axis(nd_text *svg, double step, double end, int bottom, const char *unit) {
    for (double x = 0.0; x <= end * 1.0001; x += step) {
        double at = LEFT + (RIGHT - LEFT) * x / end;
        add(svg, "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\" stroke=\"#ccc\"/>\n", at, at,
            TOP, bottom);
        add(svg, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>\n", at, bottom + 16,
            x);
    }
    add(svg, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">", (LEFT + RIGHT) / 2, bottom + 36);
    add_escaped(svg, unit);
    nd_text_add(svg, "</text>\n");
}

void bench_chart(nd_text *svg, const char *title, const char *unit, const bench_bar *bars,
                 size_t n) {
    int bottom = TOP + ROW * (int)n + 4, height = bottom + 48;
    double most = 0.0;
    for (size_t i = 0; i < n; i++)
        most = bars[i].value > most ? bars[i].value : most;
    double step = step_of(most > 0.0 ? most : 1.0), end = step * ceil(most / step);
    add(svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
        "viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" font-size=\"12\">\n",
        WIDTH, height, WIDTH, height);
    nd_text_add(svg, "<title>");
    add_escaped(svg, title);
    nd_text_add(svg, "</title>\n<!-- MIT-0: use this picture without notice or condition. -->\n");
    add(svg, "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n<g fill=\"#222\">\n", WIDTH,
        height);
    nd_text_add(svg, "<text x=\"16\" y=\"28\" font-size=\"15\">");
    add_escaped(svg, title);
    nd_text_add(svg, "</text>\n");
    add_axis(svg, step, end > 0.0 ? end : 1.0, bottom, unit);
    for (size_t i = 0; i < n; i++) {
        int y = TOP + ROW * (int)i;
        double length = end > 0.0 ? (RIGHT - LEFT) * bars[i].value / end : 0.0;
        add(svg, "<text x=\"%d\" y=\"%d\" text-anchor=\"end\">", LEFT - 8, y + 16);
        add_escaped(svg, bars[i].label);
        add(svg,
            "</text>\n<rect x=\"%d\" y=\"%d\" width=\"%.1f\" height=\"%d\" fill=\"#3b6ea5\"/>\n",
            LEFT, y + 5, length, ROW - 6);
        add(svg, "<text x=\"%.1f\" y=\"%d\">%.4g</text>\n", LEFT + length + 6.0, y + 16,
            bars[i].value);
    }
    nd_text_add(svg, "</g>\n</svg>\n");
}
