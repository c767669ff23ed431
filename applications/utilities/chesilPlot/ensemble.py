"""Runs that differ by their seed alone: mean and spread of columns over time, a colour a group.

A group is label=<pattern of case folders>, quoted; a column may be the ratio of two, kineticEnergy/contactEnergy.
"""

import glob
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import style
from plotError import PlotError
from series import labelOf, readable, readSeriesFile


def addGroups(parser):
    parser.add_argument("-groups", nargs="+", required=True, metavar="<label=pattern>", help="case folders of each group")
    parser.add_argument("-title", metavar="<text>")


def addOptions(parser):
    addGroups(parser)
    parser.add_argument("-measure", default="world", metavar="<name>", help="whose .dat (default: world)")
    parser.add_argument("-columns", nargs="+", required=True, metavar="<name>")
    parser.add_argument("-log", action="store_true", help="logarithmic values")


def groupsOf(options):
    """[(label, [case folder])], every group with a run at least."""
    groups = []
    for text in options.groups:
        label, equals, pattern = text.partition("=")
        cases = sorted(path for path in glob.glob(pattern) if (Path(path) / "postProcessing").is_dir())
        if not equals or not cases:
            raise PlotError(f"{text}: found no run; expected label=<pattern of case folders>, quoted")
        groups.append((label, cases))
    return groups


def readRun(case, measure):
    """(heads, columns) of a measure over all starts of a run, in the order of time."""
    files = sorted(Path(case).glob(f"postProcessing/chesilDEM/*/{measure}.dat"), key=lambda path: float(path.parent.name))
    if not files:
        raise PlotError(f"{case}: no {measure}.dat; name it in 'measures' and run again")
    parts = [readSeriesFile(str(path)) for path in files]
    return parts[0][0], np.hstack([columns for _, columns in parts])


def column(case, heads, columns, name):
    """(values, unit) of a column or of the ratio of two."""
    names = [head for head, _ in heads]
    indices = []
    for part in name.split("/"):
        if part not in names:
            raise PlotError(f"{case}: no column '{part}' (known: {' '.join(names)})")
        indices.append(names.index(part))
    if len(indices) == 1:
        return columns[indices[0]], heads[indices[0]][1]
    with np.errstate(divide="ignore", invalid="ignore"):
        return columns[indices[0]] / columns[indices[1]], "-"


def spread(axes, x, curves, colour, label, geometric=False):
    """Mean and extremes of curves at common places; on a logarithmic scale the geometric mean."""
    with np.errstate(divide="ignore", invalid="ignore"):
        mean = np.exp(np.mean(np.log(curves), axis=0)) if geometric else np.mean(curves, axis=0)
    axes.fill_between(x, np.min(curves, axis=0), np.max(curves, axis=0), color=colour, alpha=0.2, linewidth=0)
    axes.plot(x, mean, color=colour, label=label)


def title(options, groups):
    runs = sorted({len(cases) for _, cases in groups})
    number = " or ".join(map(str, runs))
    return options.title or ("one run" if runs == [1] else f"mean and extremes of {number} runs")


def draw(options):
    groups = groupsOf(options)
    figure, panels = plt.subplots(1, len(options.columns), figsize=(min(4.4 * len(options.columns), 9.0), 3.2), squeeze=False,
                                  layout="constrained")
    for axes, name in zip(panels[0], options.columns):
        unit = ""
        for number, (label, cases) in enumerate(groups):
            runs = [(case, *readRun(case, options.measure)) for case in cases]
            end = min(columns.shape[1] for _, _, columns in runs)
            curves = []
            for case, heads, columns in runs:
                values, unit = column(case, heads, columns, name)
                curves.append(values[:end])
            curves = np.array(curves)
            if options.log:
                curves = np.where(curves > 0, curves, np.nan)
            x = runs[0][2][0, :end]
            whole = np.isfinite(curves).all(axis=0)
            spread(axes, x[whole], curves[:, whole], style.SERIES_COLOURS[number], label, options.log)
        axes.set_yscale("log" if options.log else "linear")
        axes.grid(True)
        axes.margins(x=0)
        axes.set_xlabel("time [s]")
        axes.set_ylabel(labelOf(" / ".join(readable(part) for part in name.split("/")), unit))
    panels[0, 0].legend(loc="best")
    figure.suptitle(title(options, groups), x=0.02, ha="left", fontsize=10)
    return figure
