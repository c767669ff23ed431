"""Reads what Chesil writes for ParaView: .vtp (XML PolyData, ASCII) and .pvd (the list of times)."""

import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plotError import PlotError


@dataclass
class PolyData:
    points: np.ndarray  # x and y of each point [m]
    polygons: list  # indices of points, one array a polygon
    lines: list
    fields: dict  # name -> one value (or vector) a cell

    def outlines(self):
        return [self.points[indices] for indices in self.polygons]

    def polylines(self):
        return [self.points[indices] for indices in self.lines]


def _parse(path):
    try:
        return ElementTree.parse(path).getroot()
    except FileNotFoundError:
        raise PlotError(f"{path}: no such file") from None
    except ElementTree.ParseError as error:
        raise PlotError(f"{path}: not a complete XML file ({error})") from None


def _array(path, element):
    if element.get("format", "ascii") != "ascii":
        raise PlotError(f"{path}: array {element.get('Name')} is not ASCII; write it with format=\"ascii\"")
    values = np.array((element.text or "").split(), dtype=float)
    width = int(element.get("NumberOfComponents", 1))
    return values.reshape(-1, width) if width > 1 else values


def _arrays(path, element):
    return {} if element is None else {array.get("Name"): _array(path, array) for array in element.iter("DataArray")}


def _cells(path, piece, kind):
    arrays = _arrays(path, piece.find(kind))
    if not arrays:
        return []
    ends = arrays["offsets"].astype(int)
    return np.split(arrays["connectivity"].astype(int), ends)[:-1] if len(ends) else []


def readPolyData(path):
    piece = _parse(path).find("PolyData/Piece")
    if piece is None:
        raise PlotError(f"{path}: holds no PolyData")
    points = [_array(path, array) for array in piece.findall("Points/DataArray")]
    if not points:
        raise PlotError(f"{path}: holds no points")
    return PolyData(
        points=points[0].reshape(-1, 3)[:, :2],
        polygons=_cells(path, piece, "Polys"),
        lines=_cells(path, piece, "Lines"),
        fields=_arrays(path, piece.find("CellData")),
    )


def readSeries(path):
    """[(time, file)] of a .pvd, in the order of time."""
    entries = [
        (float(entry.get("timestep")), Path(path).parent / entry.get("file"))
        for entry in _parse(path).iter("DataSet")
    ]
    if not entries:
        raise PlotError(f"{path}: lists no data sets")
    return sorted(entries)


def nearest(entries, time, where):
    """The entry (time, ...) nearest to a time; an error if none lies within half a writing interval."""
    best = min(entries, key=lambda entry: abs(entry[0] - time))
    times = sorted(entry[0] for entry in entries)
    interval = max((b - a for a, b in zip(times, times[1:])), default=0.0)
    if abs(best[0] - time) > 0.5001 * interval + 1e-9 * abs(time):
        raise PlotError(f"{where}: nothing at time {time:g}; it goes from {times[0]:g} to {times[-1]:g}")
    return best


def readWalls(folder):
    """Polylines of walls.vtp in a folder; none if there is no such file."""
    path = Path(folder) / "walls.vtp"
    return readPolyData(path).polylines() if path.is_file() else []
