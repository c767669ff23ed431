"""Reads template files (doc/templateFile.md) into exact outlines for matplotlib."""

import numpy as np
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from plotError import PlotError


def polyBezierPath(controls):
    """controls: 3 N points, P0 Q1 Q2 of each segment; its end is the next one's P0."""
    vertices = np.vstack([controls, controls[:1], controls[:1]])
    codes = np.full(len(vertices), Path.CURVE4)
    codes[0] = Path.MOVETO
    codes[-1] = Path.CLOSEPOLY
    return Path(vertices, codes)


def polygonPath(corners):
    return Path(np.vstack([corners, corners[:1]]), closed=True)


def ellipsePath(semiAxes):
    return Path.unit_circle().transformed(Affine2D().scale(*semiAxes))


def outlineArea(path):
    """Of a closed outline, counter-clockwise; exact for cubic segments, by Gauss' rule of three points."""
    places, weights = np.polynomial.legendre.leggauss(3)
    t = (places[:, None] + 1) / 2
    area, first, start = 0.0, None, None
    for points, code in path.iter_segments(simplify=False, curves=True):
        points = first[None] if code == Path.CLOSEPOLY else points.reshape(-1, 2)
        if code == Path.MOVETO:
            first = points[0]
        elif code == Path.CURVE4:
            p0, q1, q2, p3 = start, *points
            place = (1 - t) ** 3 * p0 + 3 * (1 - t) ** 2 * t * q1 + 3 * (1 - t) * t ** 2 * q2 + t ** 3 * p3
            slope = 3 * ((1 - t) ** 2 * (q1 - p0) + 2 * (1 - t) * t * (q2 - q1) + t ** 2 * (p3 - q2))
            area += weights @ (place[:, 0] * slope[:, 1] - place[:, 1] * slope[:, 0]) / 4
        else:
            area += (start[0] * points[0, 1] - start[1] * points[0, 0]) / 2
        start = points[-1]
    return area


class Reader:
    """The meaningful lines of a file, with their numbers for messages."""

    def __init__(self, path):
        self.path = path
        self.number = 0
        with open(path) as file:
            self.lines = [line.split("#")[0].split() for line in file]

    def next(self):
        while self.number < len(self.lines):
            self.number += 1
            if self.lines[self.number - 1]:
                return self.lines[self.number - 1]
        raise self.error("the file is cut short: it must close with 'end'")

    def error(self, message):
        return PlotError(f"{self.path}:{self.number}: {message}")

    def points(self, lines):
        try:
            return np.array([self.next() for _ in range(lines)], dtype=float).reshape(-1, 2)
        except ValueError:
            raise self.error("a line must hold coordinates x y ...") from None


def readGrain(reader, kind, parameters):
    try:
        if kind == "polybezier":
            return polyBezierPath(reader.points(int(parameters[0])))
        if kind == "polygon":
            return polygonPath(reader.points(int(parameters[0])))
        if kind == "circle":
            return ellipsePath([float(parameters[0])] * 2)
        if kind == "ellipse":
            return ellipsePath([float(parameters[0]), float(parameters[1])])
    except (IndexError, ValueError):
        raise reader.error(f"a {kind} needs other numbers than '{' '.join(parameters)}'") from None
    raise reader.error(f"unknown kind of grain '{kind}' (known: polybezier polygon circle ellipse)")


def readTemplates(path):
    """(unit, {name: outline in the grain's own frame})"""
    reader = Reader(path)
    if reader.next()[0] != "chesilTemplates":
        raise reader.error("must begin with 'chesilTemplates 1'")
    unit, grains = "m", {}
    words = reader.next()
    while words[0] != "end":
        if words[0] == "unit":
            unit = words[1]
        elif words[0] == "grain":
            if len(words) < 4:
                raise reader.error("must be: grain <name> <kind> <numbers>")
            grains[words[1]] = readGrain(reader, words[2], words[3:])
        elif words[0] != "count":
            raise reader.error(f"unknown entry '{words[0]}' (known: unit count grain end)")
        words = reader.next()
    return unit, grains
