"""Compares the disk's force in grains.dat with the change of the fluid's momentum."""

import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from foamCase import BlockMesh, field, within

# As in the case
DENSITY, TIME_STEP, STEPS = 1000.0, 0.001, 4
START = np.array((0.3, -0.2))

mesh = BlockMesh(".")
times = [f"{step * TIME_STEP:g}" for step in range(1, STEPS + 1)]
# [N s] a metre of depth: areas stand for volumes
momenta = [DENSITY * mesh.areas().sum() * START]
momenta += [DENSITY * mesh.areas() @ field(".", time, "U")[:, :2] for time in times]
expected = -np.diff(momenta, axis=0) / TIME_STEP

rows = np.loadtxt("postProcessing/grains/0/grains.dat")
forces = rows[:, 8:10]
assert np.allclose(rows[:, 0], np.arange(1, STEPS + 1) * TIME_STEP), "grains.dat has other times"

for step in range(STEPS):
    size = np.linalg.norm(expected[step])
    assert size > 1, "hardly any force to compare"
    within(f"force at {times[step]} s: error over {size:.4g} N/m",
           np.linalg.norm(forces[step] - expected[step]) / size, 1e-9)
