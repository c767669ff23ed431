"""What the scripts of this folder share: the shapes of the chart and the accuracy of each fit."""

import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "applications/utilities/chesilPlot"))
from fitReport import percent  # noqa: E402,F401

MODELS = ("polybezier", "polygon")
PIECES = range(3, 21)
# (sphericity, roundness) of the two shapes of Figs. 8 and 9
ROUND, ANGULAR = (0.7, 0.9), (0.7, 0.1)


def readTable(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def readShapes():
    """{(sphericity, roundness): name of the grain}"""
    return {(float(row["sphericity"]), float(row["roundness"])): row["id"] for row in readTable("runs/shapes.csv")}


def readAccuracy():
    """{(model, pieces, name of the grain): accuracy to the silhouette}"""
    return {(model, pieces, row["id"]): float(row["accuracySilhouette"])
            for model in MODELS for pieces in PIECES for row in readTable(f"runs/{model}{pieces}.csv")}


def readDescribed(source):
    """{name of the grain: (elongation, roundness of corners)} of the image or the templates"""
    return {row["id"]: (float(row["elongation"]), float(row["cornerRoundness"])) for row in readTable(f"runs/{source}.csv")}
