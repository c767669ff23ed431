"""Grains of one state, with their true outlines, and the walls.

Takes a .vtp file or the .pvd list of all times. The walls come from walls.vtp beside the grains.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap

import style
from plotError import PlotError
from vtp import nearest, readPolyData, readSeries, readWalls

# What Chesil's cell fields are called in a picture, and their units
FIELD_LABELS = {
    "size": "size [m]",
    "speed": "speed [m/s]",
    "angle": "angle [rad]",
    "angularVelocity": "angular velocity [rad/s]",
}

# Of the field "kind"
KINDS = [("circle", "#DCC296"), ("ellipse", "#A9CCE3"), ("polygon", "#F3E6CB"), ("polybezier", "#D0946A")]

MEAN_FORCE_WIDTH = 0.9  # points

# Values closer than this, relative to the largest, are one: files hold rounded coordinates
LEAST_SPREAD = 1e-4


def addOptions(parser):
    parser.add_argument("file", metavar="<vtp or pvd>")
    parser.add_argument("-time", type=float, metavar="<s>", help="of a .pvd, take the state at this time (default: last)")
    parser.add_argument("-field", metavar="<name>", help="colour by this cell field (default: by size)")
    parser.add_argument("-forces", action="store_true",
                        help="force chains: contacts as lines as wide as their normal force (entry forceChains)")
    parser.add_argument("-label", metavar="<text>", help="of the colour bar, with the unit")
    parser.add_argument("-title", metavar="<text>")


def areaOf(outline):
    x, y = outline.T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def readState(options):
    """(time or None, file) of the state to draw."""
    if not options.file.endswith(".pvd"):
        return None, options.file
    entries = readSeries(options.file)
    return entries[-1] if options.time is None else nearest(entries, options.time, options.file)


def fieldValues(grains, options, factor, unit):
    """One value a grain, and what to call it."""
    if options.field is None:
        diameters = [2 * np.sqrt(areaOf(outline) / np.pi) for outline in grains.outlines()]
        return np.array(diameters) * factor, f"equivalent diameter [{unit}]"
    if options.field not in grains.fields:
        raise PlotError(f"no field '{options.field}' (known: {' '.join(sorted(grains.fields))})")
    values = grains.fields[options.field]
    if values.ndim > 1:
        values = np.linalg.norm(values, axis=1)
    return values, FIELD_LABELS.get(options.field, options.field)


def regionInSight(grains, walls):
    """(lower, upper corner) of grains and walls, without the empty part of a box far above the grains."""
    everything = np.vstack(grains.outlines() + walls)
    low, high = everything.min(axis=0), everything.max(axis=0)
    grainsTop = np.vstack(grains.outlines()).max(axis=0)[1]
    high[1] = min(high[1], grainsTop + 0.1 * (high[0] - low[0]))
    return low, high


def drawColourBar(drawn, axes, values, label):
    """With a single colour and tick if all grains have the same value: the rest would be rounding."""
    low, high = values.min(), values.max()
    if high - low > LEAST_SPREAD * max(abs(low), abs(high)):
        style.colourBar(drawn, axes, label)
        return
    middle = (low + high) / 2
    drawn.set_cmap(ListedColormap([style.SAND(0.5)]))
    drawn.set_clim(middle - 1, middle + 1)
    bar = style.colourBar(drawn, axes, label)
    bar.set_ticks([middle], labels=[f"{middle:.4g}"])


def drawKinds(axes, outlines, kinds):
    """A colour a kind of outline, and their names below."""
    present = [kind for kind in range(len(KINDS)) if (kinds == kind).any()]
    style.drawGrains(axes, outlines, facecolor=[KINDS[int(kind)][1] for kind in kinds])
    handles = [plt.Rectangle((0, 0), 1, 1, facecolor=KINDS[kind][1], edgecolor=style.GRAIN_EDGE, linewidth=0.6) for kind in present]
    axes.figure.legend(handles, [KINDS[kind][0] for kind in present], loc="upper center", bbox_to_anchor=(0.5, 0.02), ncol=4)


def drawForces(axes, path, factor):
    """Contacts as lines from centroid to centroid, as wide as their normal force."""
    if not path.name.startswith("grains_"):
        raise PlotError(f"{path}: found no contacts beside it; it is no grains_<n>.vtp")
    contacts = path.with_name(path.name.replace("grains_", "contacts_", 1))
    if not contacts.is_file():
        raise PlotError(f"{contacts}: no such file; set 'forceChains yes' and run again")
    found = readPolyData(contacts)
    forces = found.fields["normalForce"] if found.lines else np.zeros(0)
    mean = forces.mean() if len(forces) else 1.0
    widths = MEAN_FORCE_WIDTH * np.maximum(forces, 0) / mean
    axes.add_collection(LineCollection([line * factor for line in found.polylines()], linewidths=widths,
                                       colors=style.OUTLINE, capstyle="round", zorder=5))
    handle = plt.Line2D([], [], color=style.OUTLINE, linewidth=MEAN_FORCE_WIDTH)
    axes.figure.legend([handle], [f"normal force of the mean, {mean:.3g} N"], loc="upper center", bbox_to_anchor=(0.5, 0.02))


def draw(options):
    time, path = readState(options)
    grains = readPolyData(path)
    if not grains.polygons:
        raise PlotError(f"{path}: holds no grains")
    walls = readWalls(Path(path).parent)

    low, high = regionInSight(grains, walls)
    factor, unit = style.lengthUnit((high - low).max() / 10)
    outlines = [outline * factor for outline in grains.outlines()]

    figure, (axes,) = style.panels(1, high - low, tallest=5.0)
    drawn = None
    if options.forces:
        style.drawGrains(axes, outlines, facecolor=style.PALE_GRAIN, edgecolor=style.FAINT_INK)
        drawForces(axes, Path(path), factor)
    elif options.field == "kind":
        drawKinds(axes, outlines, grains.fields["kind"])
    else:
        values, label = fieldValues(grains, options, factor, unit)
        drawn = style.drawGrains(axes, outlines, array=values, cmap=style.SAND)
    style.drawWalls(axes, [line * factor for line in walls])
    style.show(axes, low * factor, high * factor)
    style.placeLengthAxes(axes, unit)
    style.scaleBar(axes, unit)
    if drawn:
        drawColourBar(drawn, axes, values, options.label or label)
    axes.set_title(options.title or (f"{len(outlines)} grains" + (f" at {time:g} s" if time is not None else "")))
    return figure
