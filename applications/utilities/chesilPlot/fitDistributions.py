"""Size of fitted grains, as the share of the area of finer ones, and their accuracy.

The report and the templates are those that chesilFit writes.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter, ScalarFormatter

import style
from fitReport import percent, readReport
from plotError import PlotError
from templateFile import outlineArea, readTemplates

MARKS = (10, 50, 90)  # percent
LEAST_ERROR = 1e-4  # drawn for fits without a wrong pixel


def addOptions(parser):
    parser.add_argument("report", metavar="<csv>")
    parser.add_argument("-templates", required=True, metavar="<chesil>", help="the fitted grains")


def areasOf(options, names):
    """(areas, unit of length)"""
    unit, templates = readTemplates(options.templates)
    missing = [name for name in names if name not in templates]
    if missing:
        raise PlotError(f"{options.report}: grain '{missing[0]}' is not among the templates")
    return np.array([outlineArea(templates[name]) for name in names]), unit


def drawSizes(axes, areas, unit):
    diameters = np.sqrt(4 * np.sort(areas) / np.pi)
    factor, unit = (1.0, unit) if unit == "pixel" else style.lengthUnit(np.median(diameters))
    diameters *= factor
    finer = 100 * np.cumsum(np.sort(areas)) / areas.sum()
    axes.step(np.append(diameters[0], diameters), np.append(0, finer), where="post", color=style.SERIES_COLOURS[0])
    axes.set_xscale("log")
    ends = diameters[0] / 1.15, diameters[-1] * 1.15
    axes.set_xlim(*ends)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if ends[1] < 50 * ends[0] else (1,)))
    axes.xaxis.set_major_formatter(ScalarFormatter())
    axes.xaxis.set_minor_formatter(NullFormatter())
    marked = []
    for mark in MARKS:
        diameter = diameters[np.searchsorted(finer, mark)]
        axes.plot([ends[0], diameter, diameter], [mark, mark, 0], color=style.FAINT_INK, linewidth=0.8, linestyle=":")
        marked.append(f"d{mark} = {diameter:.3g}")
    axes.set_xlabel(f"equivalent diameter [{unit}]")
    axes.set_ylabel("area of the finer grains [%]")
    axes.set_title(f"{len(areas)} grains: {', '.join(marked)} {unit}")


def drawAccuracies(axes, columns):
    """On a logarithmic scale of the share of wrong pixels."""
    least = 1.0
    for name, label, colour, line in (("accuracySilhouette", "silhouette", style.OUTLINE, "-"),
                                      ("accuracyHull", "its hull", style.SERIES_COLOURS[0], "--")):
        errors = np.sort(np.maximum(1 - columns[name], LEAST_ERROR))[::-1]
        shares = 100 * np.arange(1, len(errors) + 1) / len(errors)
        axes.step(np.append(errors[0], errors), np.append(0, shares), where="post", color=colour, linestyle=line,
                  label=f"{label} (median {percent(np.median(columns[name]))})")
        least = min(least, errors[-1])
    axes.set_xscale("log")
    ticks = np.array([step * power for power in (1e-1, 1e-2, 1e-3, 1e-4) for step in (5, 2, 1)])
    largest = max(1 - columns["accuracySilhouette"].min(), 1 - columns["accuracyHull"].min(), LEAST_ERROR)
    ends = 1.15 * largest, least / 1.15
    ticks = [tick for tick in ticks if ends[1] <= tick <= ends[0]]
    if len(ticks) > 7:
        ticks = [tick for tick in ticks if f"{tick:e}"[0] == "1"]
    axes.set_xlim(*ends)
    axes.set_xticks(ticks, [("≥ " if tick <= LEAST_ERROR else "") + f"{100 * (1 - tick):.4g} %" for tick in ticks])
    axes.minorticks_off()
    axes.set_xlabel("accuracy")
    axes.set_ylabel("grains of less accuracy [%]")
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncol=2, fontsize=8, columnspacing=1.5, handlelength=1.2,
                borderaxespad=0.2)


def draw(options):
    columns, names = readReport(options.report)
    figure, (sizes, accuracies) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    drawSizes(sizes, *areasOf(options, names))
    drawAccuracies(accuracies, columns)
    for axes in (sizes, accuracies):
        axes.grid(True)
        axes.set_ylim(0, 100)
    return figure
