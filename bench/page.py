# SPDX-License-Identifier: Apache-2.0
"""RESULTS.md as text: tables of Markdown, and a bar chart in SVG."""

import html
import math


def number(x, digits=3):
    """Three significant digits, a dash for what was not measured."""
    if x is None or (isinstance(x, float) and math.isnan(x)):
        return "-"
    if isinstance(x, str):
        return x
    if abs(x) >= 100:
        return f"{x:.0f}"
    return f"{x:.{digits}g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(number(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def chart(title, unit, groups):
    """groups: (heading, [(label, value)]); one bar for each value, the headings between them."""
    left, right, width, row = 330, 760, 840, 20
    most = max((v for _, bars in groups for _, v in bars if not math.isnan(v)), default=1.0)
    step = 10 ** math.floor(math.log10(most / 4))
    step *= next(k for k in (1, 2, 5, 10) if most / 4 / step <= k)
    end = step * math.ceil(most / step)
    parts, y = [], 56
    for heading, bars in groups:
        parts.append(f'<text x="16" y="{y + 16}" font-weight="bold">{html.escape(heading)}</text>')
        y += row
        for label, value in bars:
            shown = 0 if math.isnan(value) else value
            length = (right - left) * shown / end
            parts.append(
                f'<text x="{left - 8}" y="{y + 14}" text-anchor="end">{html.escape(label)}</text>'
            )
            parts.append(
                f'<rect x="{left}" y="{y + 3}" width="{length:.1f}" height="{row - 6}" '
                f'fill="{"#3b6ea5" if label.startswith("ndotl") else "#b0b6bd"}"/>'
            )
            parts.append(f'<text x="{left + length + 6:.1f}" y="{y + 14}">{number(value)}</text>')
            y += row
        y += row // 2
    bottom = y
    for k in range(round(end / step) + 1):
        x = left + (right - left) * k * step / end
        parts.insert(0, f'<line x1="{x:.1f}" x2="{x:.1f}" y1="56" y2="{bottom}" stroke="#ddd"/>')
        parts.append(
            f'<text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle">{k * step:g}</text>'
        )
    parts.append(
        f'<text x="{(left + right) / 2:g}" y="{bottom + 36}" text-anchor="middle">'
        f"{html.escape(unit)}"
        "</text>"
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{bottom + 48}" '
        f'viewBox="0 0 {width} {bottom + 48}" font-family="sans-serif" font-size="12">\n'
        f"<title>{html.escape(title)}</title>\n"
        "<!-- MIT-0: use this picture without notice or condition. -->\n"
        f'<rect width="{width}" height="{bottom + 48}" fill="#fff"/>\n<g fill="#222">\n'
        f'<text x="16" y="28" font-size="15">{html.escape(title)}</text>\n'
        + "\n".join(parts)
        + "\n</g>\n</svg>\n"
    )
