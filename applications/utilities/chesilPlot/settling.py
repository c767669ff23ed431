"""Grains in a flow at some moments, with the fluid's speed behind them.

Reads the grains from <case>/grains.pvd and the velocity from a plane that the stock function object
"surfaces" has sampled with surfaceFormat raw: <case>/postProcessing/<any name>/<time>/U_<any name>.raw.
"""

import re
from pathlib import Path

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.tri import Triangulation

import style
from plotError import PlotError
from vtp import nearest, readPolyData, readSeries, readWalls


def addOptions(parser):
    parser.add_argument("case", metavar="<case>")
    parser.add_argument("-times", type=float, nargs="+", metavar="<s>", help="moments to show (default: three)")
    parser.add_argument("-fastest", type=float, metavar="<m/s>", help="end of the colour scale (default: the fastest shown)")


def sampledTimes(case):
    """[(time, file)] of the sampled velocity, in the order of time."""
    found = []
    for path in Path(case).glob("postProcessing/*/*/*.raw"):
        if re.match(r"U\b|U_", path.name) and re.fullmatch(r"[0-9.e+-]+", path.parent.name):
            found.append((float(path.parent.name), path))
    if not found:
        raise PlotError(f"{case}: no postProcessing/*/<time>/U_*.raw (function object 'surfaces', surfaceFormat raw)")
    return sorted(found)


def readSpeed(path):
    """Points (x, y) and the speed there, without the points that the file gives twice."""
    columns = np.loadtxt(path, comments="#", ndmin=2)
    if columns.shape[1] != 6:
        raise PlotError(f"{path}: must have the columns x y z Ux Uy Uz")
    points, first = np.unique(columns[:, :2].round(12), axis=0, return_index=True)
    return points, np.linalg.norm(columns[first, 3:], axis=1)


def chooseTimes(options, entries):
    if options.times:
        return options.times
    return [entries[round(share * (len(entries) - 1))][0] for share in (0.15, 0.5, 1.0)]


def readMoments(options):
    """[(time, points, speeds, grains)]"""
    velocity = sampledTimes(options.case)
    grains = readSeries(Path(options.case) / "grains.pvd")
    moments = []
    for wanted in chooseTimes(options, velocity):
        time, path = nearest(velocity, wanted, f"{options.case}/postProcessing")
        grainTime, grainFile = nearest(grains, time, f"{options.case}/grains.pvd")
        if abs(grainTime - time) > 1e-5 * max(time, 1e-9):
            raise PlotError(f"{options.case}: velocity at {time:g} s, but no grains at that time: write both together")
        moments.append((time, *readSpeed(path), readPolyData(grainFile)))
    return moments


def tank(points):
    """(lower, upper corner) of the mesh whose cell centres these are."""
    low, high = points.min(axis=0), points.max(axis=0)
    halfCell = 0.5 * np.sqrt(np.prod(high - low) / len(points))
    return low - halfCell, high + halfCell


def drawMoment(axes, moment, walls, factor, scale):
    time, points, speeds, grains = moment
    axes.set_facecolor(style.WATER(0.0))  # the half cell between the last value and the wall, where water rests
    axes.set_title(f"t = {time:g} s")
    drawn = axes.tripcolor(Triangulation(*(points.T * factor)), speeds, cmap=style.WATER, norm=scale,
                           shading="gouraud", rasterized=True)
    style.drawGrains(axes, [outline * factor for outline in grains.outlines()], facecolor=style.GRAIN_FILL)
    style.drawWalls(axes, [line * factor for line in walls])
    return drawn


def draw(options):
    moments = readMoments(options)
    walls = readWalls(Path(options.case) / "grains")
    low, high = tank(moments[0][1])
    factor, unit = style.lengthUnit((high - low).max() / 10)
    scale = Normalize(0, options.fastest or max(speeds.max() for _, _, speeds, _ in moments) or 1.0)

    figure, panels = style.panels(len(moments), high - low)
    for axes, moment in zip(panels, moments):
        drawn = drawMoment(axes, moment, walls, factor, scale)
        style.show(axes, low * factor, high * factor)
        style.placeLengthAxes(axes, unit, labelled=axes is panels[0])
    style.scaleBar(panels[-1], unit)
    style.colourBar(drawn, panels[-1], "speed of the water [m/s]")
    return figure
