"""Reads small ASCII cases of OpenFOAM, for the checks beside it."""

import pathlib
import re

import numpy as np


def numbersIn(text):
    """All numbers of a list such as ((1 2 3) (4 5 6)), flat."""
    return np.array(re.sub(r"[()]", " ", text).split(), dtype=float)


def listIn(text):
    """Length and numbers of the first list "<length> ( ... )" of a file."""
    found = re.search(r"^(\d+)\s*\((.*?)^\)", text, re.DOTALL | re.MULTILINE)
    return int(found[1]), numbersIn(found[2])


def field(case, time, name):
    """Values of a field's cells, one row a cell."""
    text = (pathlib.Path(case) / time / name).read_text()
    length, values = listIn(text[text.index("internalField") :])
    return values.reshape(length, -1)


class BlockMesh:
    """A mesh of one block along the axes, one cell deep: cell i + nx j lies between x[i], x[i+1] and y[j], y[j+1]."""

    def __init__(self, case):
        length, values = listIn((pathlib.Path(case) / "constant/polyMesh/points").read_text())
        points = values.reshape(length, 3)
        # x runs fastest, then y
        columns = int(np.argmax(np.diff(points[:, 0]) < 0)) + 1
        self.x, self.y = points[:columns, 0], points[: length // 2 : columns, 1]

    def areas(self):
        return np.outer(np.diff(self.y), np.diff(self.x)).ravel()

    def cells(self):
        """Lower left and upper right corner of each cell."""
        for j in range(len(self.y) - 1):
            for i in range(len(self.x) - 1):
                yield (self.x[i], self.y[j]), (self.x[i + 1], self.y[j + 1])


def within(what, value, bound):
    """Prints the value beside its bound; ends the check if it is outside (or no number)."""
    print(f"{what}: {value:.3g}, allowed {bound:g}")
    if not abs(value) <= bound:
        raise SystemExit(f"FAILED: {what}")
