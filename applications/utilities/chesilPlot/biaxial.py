"""Stress ratio q/p and volumetric strain over axial strain of biaxial tests, mean and extremes a group.

Takes the measures `walls` (walls left, right, floor, lid) and `stress` from time -from on, where strains are 0:
axial -ln(H/H0), volumetric -ln(V/V0), compression positive; p = s_a + s_r, q = s_a - s_r of the contacts' stress.
"""

import matplotlib.pyplot as plt
import numpy as np

import style
from ensemble import addGroups, column, groupsOf, readRun, spread, title
from plotError import PlotError


def addOptions(parser):
    addGroups(parser)
    parser.add_argument("-from", dest="start", type=float, required=True, metavar="<s>", help="time at which loading begins")


def curvesOf(case, start):
    """(axial strain, stress ratio, volumetric strain) from the start of loading on."""
    heads, columns = readRun(case, "walls")
    place = {name: column(case, heads, columns, name)[0] for name in ("left.x", "right.x", "floor.y", "lid.y")}
    height = place["lid.y"] - place["floor.y"]
    width = place["right.x"] - place["left.x"]
    heads, columns = readRun(case, "stress")
    axial, radial = (column(case, heads, columns, name)[0] for name in ("yy", "xx"))
    # At a restart the same time is there twice: the later row counts
    at = np.nonzero(columns[0] >= start * (1 - 1e-9))[0]
    at = at[np.concatenate([np.diff(columns[0][at]) > 0, [True]])]
    if len(at) < 2:
        raise PlotError(f"{case}: no loading after {start:g} s")
    height, width, axial, radial = height[at], width[at], axial[at], radial[at]
    return -np.log(height / height[0]), (axial - radial) / (axial + radial), -np.log(height * width / (height[0] * width[0]))


def onCommonStrain(curves):
    """(strain, stress ratios, volumetric strains) of runs, interpolated to as many strains as one has rows."""
    strain = np.linspace(0, min(axial[-1] for axial, _, _ in curves), len(curves[0][0]))
    return strain, *(np.array([np.interp(strain, run[0], run[k]) for run in curves]) for k in (1, 2))


def draw(options):
    groups = groupsOf(options)
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.8, 3.2), layout="constrained")
    for number, (label, cases) in enumerate(groups):
        strain, ratios, volumes = onCommonStrain([curvesOf(case, options.start) for case in cases])
        spread(left, 100 * strain, ratios, style.SERIES_COLOURS[number], label)
        spread(right, 100 * strain, 100 * volumes, style.SERIES_COLOURS[number], label)
    left.set_ylabel("stress ratio q/p [-]")
    right.set_ylabel("volumetric strain [%]")
    right.axhline(0, color=style.FAINT_INK, linewidth=0.6)
    for axes in (left, right):
        axes.set_xlabel("axial strain [%]")
        axes.grid(True)
        axes.margins(x=0)
    left.legend(loc="best")
    figure.suptitle(title(options, groups), x=0.02, ha="left", fontsize=10)
    return figure
