"""Compares what chesilDEM wrote of a free fall with the formulae."""

import pathlib
import sys
import xml.etree.ElementTree as xml

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from foamCase import within

# As in chesilProperties
GRAVITY, DENSITY, RADIUS = 9.81, 2650.0, 0.05
START, VELOCITY, TURNING = np.array((0.3, 2.0)), np.array((0.4, 0.0)), 2.0
# The digits of a .vtp file: 9
PICTURE = 5e-9

area = np.pi * RADIUS**2
mass, inertia = DENSITY * area, DENSITY * area * RADIUS**2 / 2


def dataArray(root, name):
    return np.array(root.find(f".//DataArray[@Name='{name}']").text.split(), dtype=float)


pictures = [(float(entry.get("timestep")), entry.get("file")) for entry in xml.parse("grains.pvd").iter("DataSet")]
assert len(pictures) == 6, f"{len(pictures)} pictures, not one each 0.1 s"
for time, name in pictures:
    root = xml.parse(name).getroot()
    points = np.array(root.find(".//Points/DataArray").text.split(), dtype=float).reshape(-1, 3)[:, :2]
    wanted = START + VELOCITY * time - np.array((0, GRAVITY * time**2 / 2))
    # Every point of the outline lies on the circle about the centroid
    within(f"picture at {time:g} s, position", np.abs(np.hypot(*(points - wanted).T) - RADIUS).max() / wanted.max(), PICTURE)
    assert np.ptp(points, axis=0).min() > 1.99 * RADIUS, "the outline is no circle"
    within("    speed", dataArray(root, "speed")[0] / np.hypot(VELOCITY[0], GRAVITY * time) - 1, PICTURE)
    within("    angle", dataArray(root, "angle")[0] - TURNING * time, PICTURE)

series = np.loadtxt("postProcessing/chesilDEM/0/world.dat")
within("times of the series", np.abs(series[:, 0] - [time for time, _ in pictures]).max(), 1e-12)
speed2 = VELOCITY @ VELOCITY + (GRAVITY * series[:, 0]) ** 2
energy = mass * speed2 / 2 + inertia * TURNING**2 / 2
within("kinetic energy, largest relative error", np.abs(series[:, 1] / energy - 1).max(), 1e-10)
within("contact energy, contacts and overlap", np.abs(series[:, 2:5]).max(), 0)
within("mean speed, largest relative error", np.abs(series[:, 5] / np.sqrt(speed2) - 1).max(), 1e-10)
