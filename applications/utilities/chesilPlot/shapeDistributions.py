"""Distributions of size and shape of described grains.

The table is the one that chesilDescribe writes.
"""

import matplotlib.pyplot as plt
import numpy as np

import style
from descriptorTable import readDescriptors
from fitDistributions import drawSizes

SHAPES = (("elongation", "elongation"), ("sphericity", "sphericity"), ("circularity", "circularity"), ("roundness", "roundness"),
          ("cornerRoundness", "roundness of corners"))


def addOptions(parser):
    parser.add_argument("table", metavar="<csv>")


def drawShapes(axes, columns):
    for (name, label), colour in zip(SHAPES, style.SERIES_COLOURS):
        values = np.sort(columns[name])
        shares = 100 * np.arange(1, len(values) + 1) / len(values)
        axes.step(np.append(values[0], values), np.append(0, shares), where="post", color=colour,
                  label=f"{label} ({np.median(values):.2f})")
    axes.set_xlim(0, 1)
    axes.set_xlabel("descriptor (median in brackets)")
    axes.set_ylabel("grains below [%]")
    axes.legend(loc="upper left", fontsize=8)


def draw(options):
    columns, _, unit = readDescriptors(options.table)
    figure, (sizes, shapes) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    drawSizes(sizes, columns["area"], unit)
    drawShapes(shapes, columns)
    for axes in (sizes, shapes):
        axes.grid(True)
        axes.set_ylim(0, 100)
    return figure
