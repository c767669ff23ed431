"""Error against run time of numerical methods, from a benchmark's CSV.

Columns method,knob,error,time; comments before them tell what these are, with units, as in
"# error: relative error of the depth [-]".
"""

import csv
import re
from collections import defaultdict

import matplotlib.pyplot as plt
from matplotlib.patheffects import withStroke

import style
from plotError import PlotError

FLOOR = 1e-17  # where an error of exactly zero is drawn, below the rounding of doubles


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


def annotateKnobs(axes, points, colour):
    """First, middle and last, so that the reader sees which way the knob turns."""
    for index in sorted({0, len(points) // 2, len(points) - 1}):
        time, error, knob = points[index]
        axes.annotate(knob, (time, max(error, FLOOR)), xytext=(5, 4), textcoords="offset points", fontsize=7.5,
                      color=colour, path_effects=[withStroke(linewidth=2.5, foreground="white")])


def drawMethod(axes, method, points, index):
    colour = style.SERIES_COLOURS[index % len(style.SERIES_COLOURS)]
    marker = style.SERIES_MARKERS[index % len(style.SERIES_MARKERS)]
    axes.loglog([time for time, _, _ in points], [max(error, FLOOR) for _, error, _ in points],
                color=colour, marker=marker, label=method)
    exact = [time for time, error, _ in points if error < FLOOR]
    axes.plot(exact, [FLOOR] * len(exact), linestyle="none", marker=marker, color=colour, markerfacecolor="white")
    annotateKnobs(axes, points, colour)
    return bool(exact)


def draw(options):
    comments, methods = readBenchmark(options.file)
    figure, axes = plt.subplots(figsize=(6.4, 4.6), layout="constrained")
    anyExact = [drawMethod(axes, method, points, index) for index, (method, points) in enumerate(methods.items())]

    axes.grid(True, which="major")
    axes.set_axisbelow(True)
    axes.margins(0.08)
    axes.set_xlabel(comments.get("time", "time"))
    axes.set_ylabel(comments.get("error", "error"))
    if "title" in comments:
        axes.set_title(comments["title"], pad=28)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=4, borderaxespad=0.2, columnspacing=1.4,
                handletextpad=0.5)
    notes = [f"numbers: {comments['knob']}"] if "knob" in comments else []
    notes += [f"hollow: error 0, drawn at {FLOOR:g}"] if any(anyExact) else []
    axes.annotate("\n".join(notes), (1, 1), xycoords="axes fraction", xytext=(0, 5), textcoords="offset points",
                  ha="right", fontsize=7.5, color=style.FAINT_INK)
    return figure
