"""Error against run time of numerical methods, from a benchmark's CSV.

Columns method,knob,error,time; comments before them tell what these are, with units, as in
"# error: relative error of the depth [-]". "# drawing: points" is for rows that are no sweep of a knob: they are
not joined; "# drawing: bars" shows their times alone.
"""

import csv
import re
from collections import defaultdict

import matplotlib.pyplot as plt
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

import style
import timeBars
from plotError import PlotError

FLOOR = 1e-17  # where an error of exactly zero is drawn, below the rounding of doubles
LEGEND_CHARACTERS = 84  # that fit below the axes, the samples of the lines counted as six each


def addOptions(parser):
    parser.add_argument("file", metavar="<csv>")


def readBenchmark(path):
    """({name: text} of the comments, {method: [(time, error, knob)]})"""
    with open(path, newline="") as file:
        lines = file.read().splitlines()
    comments = dict(re.findall(r"^#\s*(\w+)\s*:\s*(.*)$", "\n".join(lines), flags=re.MULTILINE))
    points = defaultdict(list)
    try:
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            points[row["method"]].append((float(row["time"]), float(row["error"]), row["knob"]))
    except (KeyError, TypeError, ValueError) as error:
        raise PlotError(f"{path}: needs the columns method,knob,error,time, with numbers ({error!r})") from None
    if not points:
        raise PlotError(f"{path}: holds no measurements")
    return comments, points


def annotateKnobs(axes, methods):
    """First, last and middle of each method, so that the reader sees which way the knob turns; every other
    method on the left of its points. One that would hide another is left out."""
    axes.figure.draw_without_rendering()
    pixelsAPoint = axes.figure.dpi / 72
    placed = []
    for number, (method, points) in enumerate(methods.items()):
        side = 1 if number % 2 == 0 else -1
        for index in dict.fromkeys([0, len(points) - 1, len(points) // 2]):
            time, error, knob = points[index]
            x, y = axes.transData.transform((time, max(error, FLOOR)))
            width = 5 * pixelsAPoint * len(knob)
            left = x + 5 * pixelsAPoint if side > 0 else x - 5 * pixelsAPoint - width
            low = y + (4 if side > 0 else -10) * pixelsAPoint
            if any(left < otherLeft + otherWidth and otherLeft < left + width
                   and abs(low - otherLow) < 9 * pixelsAPoint for otherLeft, otherWidth, otherLow in placed):
                continue
            placed.append((left, width, low))
            axes.annotate(knob, (time, max(error, FLOOR)), xytext=(5 * side, 4 * side),
                          textcoords="offset points", ha="left" if side > 0 else "right",
                          va="bottom" if side > 0 else "top", fontsize=7.5, color=colourOf(number),
                          path_effects=[withStroke(linewidth=2.5, foreground="white")])


def colourOf(number):
    return style.SERIES_COLOURS[number % len(style.SERIES_COLOURS)]


def drawMethod(axes, method, points, number, joined):
    colour = colourOf(number)
    marker = style.SERIES_MARKERS[number % len(style.SERIES_MARKERS)]
    axes.loglog([time for time, _, _ in points], [max(error, FLOOR) for _, error, _ in points],
                color=colour, marker=marker, label=method, **({} if joined else {"linestyle": "none"}))
    exact = [time for time, error, _ in points if error < FLOOR]
    axes.plot(exact, [FLOOR] * len(exact), linestyle="none", marker=marker, color=colour, markerfacecolor="white")
    return bool(exact)


def drawNoise(axes, comments):
    """Comment noise, a number and what it is: errors below it are chance, and shaded."""
    if "noise" not in comments:
        return
    number, _, what = comments["noise"].partition(" ")
    low, high = axes.get_ylim()
    axes.axhspan(low, float(number), color=style.FAINT_INK, alpha=0.12, linewidth=0)
    axes.set_ylim(low, max(high, 1.2 * float(number)))
    axes.annotate(what, (1, 0), xycoords="axes fraction", xytext=(-4, 4), textcoords="offset points",
                  ha="right", va="bottom", fontsize=7.5, color=style.FAINT_INK)


def labelShortAxis(axis, low, high):
    """Less than two decades hold one power of ten or two: too few to read numbers from."""
    if high < 100 * low:
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())


def draw(options):
    comments, methods = readBenchmark(options.file)
    drawing = comments.get("drawing", "lines")
    if drawing == "bars":
        return timeBars.draw(comments, methods)
    if drawing not in ("lines", "points"):
        raise PlotError(f"{options.file}: drawing {drawing}; known: lines, points, bars")
    joined = drawing == "lines"
    figure, axes = plt.subplots(figsize=(6.4, 4.6), layout="constrained")
    anyExact = [drawMethod(axes, method, points, number, joined)
                for number, (method, points) in enumerate(methods.items())]

    axes.grid(True, which="major")
    axes.set_axisbelow(True)
    axes.margins(0.08)
    labelShortAxis(axes.xaxis, *axes.get_xlim())
    labelShortAxis(axes.yaxis, *axes.get_ylim())
    drawNoise(axes, comments)
    axes.set_xlabel(comments.get("time", "time"))
    axes.set_ylabel(comments.get("error", "error"))
    note = "numbers" if joined else "a point for each of"
    notes = [f"{note}: {comments['knob']}"] if "knob" in comments else []
    notes += [f"hollow: error 0, drawn at {FLOOR:g}"] if any(anyExact) else []
    axes.annotate("; ".join(notes), (0, 1), xycoords="axes fraction", xytext=(0, 6), textcoords="offset points",
                  fontsize=7.5, color=style.FAINT_INK)
    if "title" in comments:
        axes.set_title(comments["title"], pad=20)
    columns = LEGEND_CHARACTERS // (max(map(len, methods)) + 6)
    axes.legend(loc="upper left", bbox_to_anchor=(-0.01, -0.12), ncol=max(1, columns), borderaxespad=0.2,
                columnspacing=1.4, handletextpad=0.5)
    if joined:
        annotateKnobs(axes, methods)
    return figure
