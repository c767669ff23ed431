"""Columns of a time series (.dat with a header line of names) over its first column."""

import re

import matplotlib.pyplot as plt
import numpy as np

import style
from plotError import PlotError


def addOptions(parser):
    parser.add_argument("file", metavar="<dat>")
    parser.add_argument("-columns", nargs="+", metavar="<name>", help="which to draw (default: all)")
    parser.add_argument("-log", action="store_true", help="logarithmic values")
    parser.add_argument("-title", metavar="<text>")


def readSeriesFile(path):
    """([(name, unit)], array of columns). The header is the last comment line: names, each with [unit] or not."""
    with open(path) as file:
        comments = [line.lstrip("#").strip() for line in file if line.startswith("#")]
    if not comments:
        raise PlotError(f"{path}: needs a line '# time [s] name [unit] ...' before the numbers")
    heads = re.findall(r"([^\s\[\]]+)(?:\s*\[([^\]]*)\])?", comments[-1])
    try:
        columns = np.loadtxt(path, comments="#", ndmin=2).T
    except ValueError as error:
        raise PlotError(f"{path}: {error}") from None
    if len(columns) != len(heads):
        raise PlotError(f"{path}: {len(heads)} names in the header, {len(columns)} columns of numbers")
    return heads, columns


def chooseColumns(options, heads):
    """Indices of the columns to draw, by unit."""
    names = [name for name, _ in heads]
    byUnit = {}
    for name in options.columns or names[1:]:
        if name not in names[1:]:
            raise PlotError(f"{options.file}: no column '{name}' (known: {' '.join(names[1:])})")
        index = names.index(name)
        byUnit.setdefault(heads[index][1], []).append(index)
    return byUnit


def readable(name):
    """kineticEnergy -> kinetic energy"""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).lower()


def labelOf(name, unit):
    return readable(name) + (f" [{unit}]" if unit else "")


def draw(options):
    heads, columns = readSeriesFile(options.file)
    byUnit = chooseColumns(options, heads)
    figure, panels = plt.subplots(len(byUnit), 1, figsize=(6.4, 0.9 + 2.4 * len(byUnit)), sharex=True, squeeze=False,
                                  layout="constrained")
    for axes, (unit, indices) in zip(panels[:, 0], byUnit.items()):
        for number, index in enumerate(indices):
            axes.plot(columns[0], columns[index], color=style.SERIES_COLOURS[number % len(style.SERIES_COLOURS)],
                      label=readable(heads[index][0]))
        axes.set_yscale("log" if options.log else "linear")
        axes.grid(True)
        axes.margins(x=0)
        if len(indices) > 1:
            axes.legend(loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncol=4, borderaxespad=0.2)
            axes.set_ylabel(f"[{unit}]" if unit else "")
        else:
            axes.set_ylabel(labelOf(*heads[indices[0]]))
    panels[-1, 0].set_xlabel(labelOf(*heads[0]))
    if options.title:
        figure.suptitle(options.title, x=0.02, ha="left", fontsize=10)
    return figure
