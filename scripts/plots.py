"""Draws line plots as SVG text: the figures of the thesis and of other experiments.

A figure is a row of panels with one legend. `styles` gives each curve its label and its colour, by name.
"""

import math

WIDTH, HEIGHT = 330, 300  # of a panel
LEFT, RIGHT, TOP, BOTTOM = 58, 26, 34, 46  # around its plot
LEGEND, LEGEND_ENTRY = 26, 160  # its height, the width of an entry


def round_step(span, count):
    """Returns the step of 1, 2 or 5 times a power of ten that divides `span` into about `count` intervals."""
    rough = span / count
    power = 10.0 ** math.floor(math.log10(rough))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= rough)


def linear_axis(values):
    """Returns the marks of an axis from 0, and the function from a value to its share of the axis."""
    most = max(values)
    step = round_step(most * 1.05, 5)
    count = math.ceil(most * 1.02 / step)
    end = step * count
    return [i * step for i in range(count + 1)], lambda value: value / end


def logarithmic_axis(values):
    """Returns the marks of a logarithmic axis, at 1, 2 and 5 times the powers of ten, and the function as for linear_axis().

    Requires: values above 0.
    """
    least, most = min(values), max(values)
    powers = range(math.floor(math.log10(least)), math.ceil(math.log10(most)) + 1)
    marks = [factor * 10.0**power for power in powers for factor in (1, 2, 5)]
    first = max(i for i, mark in enumerate(marks) if mark <= least)
    last = min(i for i, mark in enumerate(marks) if mark >= most)
    low, high = math.log(marks[first]), math.log(marks[max(last, first + 1)])
    return marks[first : max(last, first + 1) + 1], lambda value: (math.log(value) - low) / (high - low)


def text(x, y, content, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{content}</text>'


def panel(curves, styles, x0, y0, labels, y_axis, has_dots):
    """Returns the elements of a panel. `labels` are its title and the labels of the x axis and the y axis."""
    title, along, up = labels
    left, bottom = x0 + LEFT, y0 + HEIGHT - BOTTOM
    width, height = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM
    most_x = max(x for curve in curves.values() for x, _ in curve)
    step_x = round_step(most_x, 5)
    marks, share = y_axis([y for curve in curves.values() for _, y in curve])

    parts = [text(left + width / 2, y0 + 20, title, more=' font-weight="bold"')]
    for mark in marks:
        y = bottom - height * share(mark)
        parts.append(f'<path d="M{left:.1f} {y:.1f}h{width}" stroke="#ddd"/>')
        parts.append(text(left - 6, y + 4, f"{mark:,.10g}", "end"))
    for i in range(int(most_x / step_x) + 1):
        x = left + width * i * step_x / most_x
        parts.append(f'<path d="M{x:.1f} {bottom:.1f}v4" stroke="#444"/>')
        parts.append(text(x, bottom + 18, f"{i * step_x:,.0f}"))
    parts.append(f'<path d="M{left:.1f} {bottom:.1f}h{width}" stroke="#444"/>')
    parts.append(text(left + width / 2, bottom + 36, along))
    middle = y0 + TOP + height / 2
    parts.append(text(x0 + 14, middle, up, more=f' transform="rotate(-90 {x0 + 14:.1f} {middle:.1f})"'))
    for name in styles:
        if name in curves:
            places = [(left + width * x / most_x, bottom - height * share(y)) for x, y in curves[name]]
            parts += line(places, styles[name][1], has_dots)
    return parts


def line(places, colour, has_dots):
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    parts = [f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>']
    if has_dots:
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>' for x, y in places]
    return parts


def legend(names, styles, width):
    parts = []
    x = max(10.0, (width - LEGEND_ENTRY * len(names)) / 2)
    for name in names:
        label, colour = styles[name]
        parts.append(f'<path d="M{x:.1f} 14h22" stroke="{colour}" stroke-width="3"/>')
        parts.append(text(x + 28, 18, label, "start"))
        x += LEGEND_ENTRY
    return parts


def figure(panels, styles, y_axis=linear_axis, has_dots=True):
    """Returns the SVG text of a figure.

    A panel is its curves {name: [(x, y), ...]}, its title and the labels of its axes.
    """
    names = [name for name in styles if any(name in curves for curves, *_ in panels)]
    width = max(WIDTH * len(panels), LEGEND_ENTRY * len(names) + 20)
    start = (width - WIDTH * len(panels)) / 2
    parts = legend(names, styles, width)
    for i, (curves, *labels) in enumerate(panels):
        parts += panel(curves, styles, start + i * WIDTH, LEGEND, labels, y_axis, has_dots)
    height = HEIGHT + LEGEND
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'font-family="sans-serif" font-size="12" fill="#222">\n<rect width="100%" height="100%" fill="white"/>\n'
    )
    return head + "\n".join(parts) + "\n</svg>\n"
