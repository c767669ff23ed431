"""Reads the tables of chesilDescribe."""

import csv

import numpy as np

from plotError import PlotError

NUMBERS = ("equivalentDiameter", "area", "elongation", "elongationAngle", "roundness", "cornerRoundness", "circularity", "sphericity",
           "convexity", "inscribedX", "inscribedY", "inscribedRadius", "circumscribedX", "circumscribedY", "circumscribedRadius")


def readDescriptors(path):
    """({column: array}, [name of the grain], unit of length), a row a grain."""
    with open(path, newline="") as file:
        lines = list(file)
    unit = "pixel"
    for line in lines:
        if line.startswith("# unit "):
            unit = line[len("# unit "):].split(",")[0].strip()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    try:
        columns = {name: np.array([float(row[name]) for row in rows]) for name in NUMBERS}
        names = [row["id"] for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise PlotError(f"{path}: is no table of chesilDescribe ({error!r})") from None
    if not names:
        raise PlotError(f"{path}: holds no grain")
    return columns, names, unit


def readOutlines(path):
    """{name: array of points}"""
    outlines = {}
    with open(path, newline="") as file:
        try:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                outlines.setdefault(row["id"], []).append((float(row["x"]), float(row["y"])))
        except (KeyError, TypeError, ValueError) as error:
            raise PlotError(f"{path}: needs the columns id,x,y ({error!r})") from None
    return {name: np.array(points) for name, points in outlines.items()}
