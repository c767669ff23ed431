"""Rose diagrams of contact normals and mean forces by direction, from roses.dat, or of long axes, from alignment.dat.

Of several files, of runs that differ by their seed alone: their mean, and bars for the extremes. With -fabric, the
Fourier curves whose amplitudes and directions fabric.dat has of the same runs.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patheffects import withStroke

import style
from plotError import PlotError
from series import readSeriesFile
from vtp import nearest

QUANTITIES = [("density", "normals [1/rad]"), ("normalForce", "normal force"), ("tangentialForce", "tangential force")]
AXES = [("density", "long axes [1/rad]")]
POSITIVE, NEGATIVE = style.SERIES_COLOURS[4], style.SERIES_COLOURS[5]


def addOptions(parser):
    parser.add_argument("files", nargs="+", metavar="<roses.dat>")
    parser.add_argument("-fabric", nargs="+", metavar="<fabric.dat>", help="draw the fitted curves, of as many files")
    parser.add_argument("-time", type=float, metavar="<s>", help="of this row (default: the last)")
    parser.add_argument("-title", metavar="<text>")


def readRow(path, time):
    """(time, {column: value}) of the row at a time, or of the last one."""
    heads, columns = readSeriesFile(path)
    entries = sorted((row[0], number) for number, row in enumerate(columns.T))
    found, number = entries[-1] if time is None else nearest(entries, time, path)
    return found, dict(zip((name for name, _ in heads), columns[:, number]))


def binsOf(path, row, quantity):
    """Values of the bins over a half turn, 0 where there is no contact."""
    values = [value for name, value in row.items() if name.startswith(quantity) and name[len(quantity):].isdigit()]
    if not values:
        raise PlotError(f"{path}: no columns {quantity}<degrees>; it is no roses.dat")
    return np.nan_to_num(np.array(values))


def fitted(path, row, quantity, angles):
    """The Fourier curve of a quantity, as doc/cases.md gives it; nothing where there was none."""
    names = {"density": ("normals", "direction"), "normalForce": ("normalForces", "normalForcesDirection"),
             "tangentialForce": ("tangentialForces", "tangentialForcesDirection")}[quantity]
    missing = [name for name in (*names, "meanNormalForce") if name not in row]
    if missing:
        raise PlotError(f"{path}: no column {missing[0]}; it is no fabric.dat")
    amplitude, direction = (row[name] for name in names)
    turned = 2 * (angles - (0 if np.isnan(direction) else direction))
    if quantity == "density":
        return (1 + amplitude * np.cos(turned)) / (2 * np.pi)
    wave = amplitude * np.cos(turned) if quantity == "normalForce" else -amplitude * np.sin(turned)
    return row["meanNormalForce"] * (wave + (quantity == "normalForce"))


def drawRose(axes, runs, curve):
    """Sectors over the full turn of the mean of runs; a negative value has the same length and another colour."""
    values = runs.mean(axis=0)
    width = np.pi / len(values)
    angles = np.arange(2 * len(values)) * width
    both = np.tile(values, 2)
    axes.bar(angles, np.abs(both), width=width, color=np.where(both < 0, NEGATIVE, POSITIVE), edgecolor="white", linewidth=0.4,
             zorder=2)
    if len(runs) > 1:
        most, least = (np.tile(extreme(np.where(values < 0, -runs, runs), axis=0), 2) for extreme in (np.max, np.min))
        axes.vlines(angles, np.maximum(least, 0), most, color=style.FAINT_INK, linewidth=0.8, zorder=2.5)
    if curve is not None:
        around = np.linspace(0, 2 * np.pi, len(curve))
        axes.plot(around, np.abs(curve), color=style.INK, linewidth=1.2, zorder=3)
    axes.set_xticks(np.arange(8) * np.pi / 4)
    axes.tick_params(labelsize=7, pad=1)
    axes.yaxis.set_major_locator(plt.MaxNLocator(3, prune="lower"))
    axes.set_rlabel_position(22.5)
    # Numbers of the rings must be read over the sectors
    axes.set_axisbelow(False)
    axes.grid(True, linewidth=0.4)
    for label in axes.get_yticklabels():
        label.set_path_effects([withStroke(linewidth=2.5, foreground="white")])
    axes.spines["polar"].set_color(style.GRID)


def meanCurve(options, fabrics, quantity, angles):
    return np.mean([fitted(path, row, quantity, angles) for path, row in zip(options.fabric, fabrics)], axis=0)


def threefold(runs):
    """Bins three times as wide, about every third one: few grains leave a rose of narrow bins ragged."""
    return (np.roll(runs, 1, axis=1) + runs + np.roll(runs, -1, axis=1))[:, ::3] / 3


def draw(options):
    rows = [readRow(path, options.time) for path in options.files]
    time = rows[0][0]
    fabrics = [readRow(path, time)[1] for path in options.fabric or []]
    heads = readSeriesFile(options.files[0])[0]
    unit = next((unit for name, unit in heads if name.startswith("normalForce")), None)
    quantities = QUANTITIES if unit else AXES
    figure, panels = plt.subplots(1, len(quantities), figsize=(3.0 * len(quantities), 3.6),
                                  subplot_kw={"projection": "polar"}, layout="constrained", squeeze=False)
    angles = np.linspace(0, 2 * np.pi, 361)
    for axes, (quantity, label) in zip(panels[0], quantities):
        curve = meanCurve(options, fabrics, quantity, angles) if fabrics else None
        runs = np.array([binsOf(path, row, quantity) for path, (_, row) in zip(options.files, rows)])
        drawRose(axes, runs if unit else threefold(runs), curve)
        axes.set_title(label if "[" in label else f"{label} [{unit}]", loc="center")
    if unit:
        handles = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in (POSITIVE, NEGATIVE)]
        labels = ["positive", "negative"]
        if fabrics:
            handles.append(plt.Line2D([], [], color=style.INK, linewidth=1.2))
            labels.append("fit")
        figure.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.02), ncol=3)
    what = f"contacts between grains at {time:g} s" if unit else f"long axes at {time:g} s"
    number = f", {len(rows)} runs" if len(rows) > 1 else ""
    figure.suptitle(options.title or what + number, x=0.02, ha="left", fontsize=10)
    return figure
