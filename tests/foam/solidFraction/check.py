"""Compares the field solidFraction of the case in this folder with areas that are clipped here."""

import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from foamCase import BlockMesh, field, within

# As in chesilProperties
TILE = np.array([(0, 0), (0.03, 0.002), (0.034, 0.015), (0.015, 0.028), (-0.004, 0.012)])
TILE_POSITION, TILE_ANGLE = np.array((0.033, 0.0401)), 0.7
DISK_POSITION, DISK_RADIUS = np.array((0.0742, 0.0377)), 0.013


def areaAndCentroid(polygon):
    x, y = (polygon - polygon[0]).T
    double = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = double.sum() / 2
    centroid = [((c + np.roll(c, -1)) * double).sum() / (6 * area) for c in (x, y)]
    return area, polygon[0] + centroid


def clipped(polygon, lower, upper):
    """Sutherland and Hodgman, for a box."""
    for axis in (0, 1):
        for side, limit in ((1, upper[axis]), (-1, lower[axis])):
            kept = []
            for a, b in zip(polygon, polygon[1:] + polygon[:1]):
                outA, outB = side * (a[axis] - limit), side * (b[axis] - limit)
                if outA <= 0:
                    kept.append(a)
                if outA * outB < 0:
                    kept.append(a + (b - a) * outA / (outA - outB))
            polygon = kept
    return polygon


def areasIn(mesh, polygon):
    polygon = list(polygon)
    parts = (clipped(polygon, *cell) for cell in mesh.cells())
    return np.array([areaAndCentroid(np.array(part))[0] if len(part) > 2 else 0.0 for part in parts])


mesh = BlockMesh(".")
fractions = field(".", "0.001", "solidFraction")[:, 0]
tileArea, centroid = areaAndCentroid(TILE)
diskArea = np.pi * DISK_RADIUS**2
total = tileArea + diskArea
within("sum of fraction times area over the grains' area, less 1", (fractions @ mesh.areas()) / total - 1, 1e-12)

cos, sin = np.cos(TILE_ANGLE), np.sin(TILE_ANGLE)
tile = areasIn(mesh, TILE_POSITION + (TILE - centroid) @ np.array([(cos, sin), (-sin, cos)]))
SIDES = 400
turns = np.arange(SIDES) * 2 * np.pi / SIDES
radius = np.sqrt(diskArea / (SIDES / 2 * np.sin(2 * np.pi / SIDES)))
disk = areasIn(mesh, DISK_POSITION + radius * np.column_stack([np.cos(turns), np.sin(turns)]))

onlyTile = disk == 0
assert (tile > 0).sum() >= 20 and (disk > 0).sum() >= 20, "the grains cover too few cells for a check"
error = np.abs(fractions - (tile + disk) / mesh.areas())
within("largest error of a fraction where the polygon is", error[onlyTile].max(), 1e-12)
within("largest error of a fraction where the disk is (against 400 sides)", error[~onlyTile].max(), 1e-5)
