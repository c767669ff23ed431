"""Reads the report of chesilFit."""

import csv

import numpy as np

from plotError import PlotError


def readReport(path):
    """({column: array}, [name of the grain]), a row a grain."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    try:
        columns = {name: np.array([float(row[name]) for row in rows]) for name in ("accuracySilhouette", "accuracyHull")}
        names = [row["id"] for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise PlotError(f"{path}: needs the columns id,accuracySilhouette,accuracyHull ({error!r})") from None
    if not names:
        raise PlotError(f"{path}: holds no grain")
    return columns, names


def percent(accuracy):
    """Never 100 %, if some pixel differs."""
    return f"{np.floor(1e4 * accuracy + 1e-9) / 100:.2f} %"
