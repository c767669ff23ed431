"""Checks what chesilDEM wrote of a periodic cell that is sheared and compressed."""

import pathlib
import sys
import xml.etree.ElementTree as xml

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from foamCase import within

# As in chesilProperties
SIDE, COMPRESSION, GRAINS, RADIUS = 0.09, 2.0, 50, 0.005


def rows(measure):
    return np.loadtxt(f"postProcessing/chesilDEM/0/{measure}.dat")


packing = rows("packing")
area = SIDE**2 * np.exp(-2 * COMPRESSION * packing[:, 0])
within("area of the cell", np.abs(packing[:, 1] / area - 1).max(), 1e-6)
within("solid fraction", np.abs(packing[:, 2] * area / (GRAINS * np.pi * RADIUS**2) - 1).max(), 1e-6)

stress = rows("stress")
assert len(stress) == 21, f"{len(stress)} rows, not one each 0.005 s"
# Direction and friction are nan without contacts, the stress is not
assert np.isfinite(stress[:, 1:7]).all(), "a stress that is no number"
dense = stress[stress[:, 0] > 0.08]
assert np.isfinite(dense).all() and np.isfinite(rows("unbalanced")[-4:]).all(), "no number in a dense cell"
print(f"dense: mean stress {dense[:, 5].mean():.4g} Pa, shear stress {dense[:, 2].mean():.4g} Pa")
assert (dense[:, 5] > 0).all(), "no pressure"
assert dense[:, 2].mean() < 0, "shear towards positive x over y puts force against it (compression is positive)"
assert np.isnan(rows("alignment")[:, 1]).all() and (rows("alignment")[:, 3] == 0).all(), "disks have no long axis"
density = rows("roses")[-1, 1:37]
within("integral of the normals' density over the full turn, less 1", 2 * density.sum() * np.pi / 36 - 1, 1e-9)

points = np.array(xml.parse("grains/walls.vtp").getroot().find(".//Points/DataArray").text.split(), dtype=float)
points = points.reshape(-1, 3)[:, :2]
assert len(points) == 5 and (points[0] == points[4]).all(), "the cell's outline is not closed"
across, along = points[1] - points[0], points[3] - points[0]
within("area of the outline drawn", (across[0] * along[1] - across[1] * along[0]) / area[-1] - 1, 1e-6)
