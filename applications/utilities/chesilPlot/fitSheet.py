"""Contact sheet of fitted grains: each cut out of the image, with its outline and its accuracy to the silhouette.

The least accurate grains come first. Files are those that chesilFit writes with -report and -placement.
"""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PathCollection
from matplotlib.transforms import Affine2D

import fit
import style
from fitReport import percent, readReport
from plotError import PlotError

COLUMNS = 8
MARGIN = 1.2  # of a cell around the grain in it


def addOptions(parser):
    fit.addOptions(parser)
    parser.add_argument("-report", required=True, metavar="<csv>", help="how well they fit")
    parser.add_argument("-byName", action="store_true", help="in the order of the report instead")
    parser.add_argument("-most", type=int, default=64, metavar="<number>", help="grains to show (default: 64)")


def chosen(options, columns, names):
    """[(name, accuracy)] to show, and what to call them."""
    if options.most < 1:
        raise PlotError(f"-most: {options.most}; expected at least 1")
    accuracies = columns["accuracySilhouette"]
    order = np.arange(len(names)) if options.byName else np.argsort(accuracies, kind="stable")
    shown = order[:options.most]
    which = "first" if options.byName else "least accurate"
    if len(shown) < len(names):
        title = f"The {len(shown)} {which} of {len(names)} fitted grains"
    else:
        title = f"All {len(names)} fitted grains" + ("" if options.byName else ", the least accurate first")
    return [(names[i], accuracies[i]) for i in shown], title


def pixelRange(middle, half, count):
    """The pixels, of so many, that a cell reaches; in pixels."""
    return max(0, math.floor(middle - half)), min(count, math.ceil(middle + half))


def cutOut(axes, fitted, outline):
    """The part of the image around the grain; each at a scale of its own."""
    low, high = outline.get_extents().get_points() / fitted.pixel
    middle, half = (low + high) / 2, MARGIN * max(high - low) / 2
    rows, columns = fitted.image.shape
    left, right = pixelRange(middle[0], half, columns)
    bottom, top = pixelRange(middle[1], half, rows)
    axes.imshow(fitted.image[rows - top:rows - bottom, left:right], cmap=style.PHOTO, vmin=0, vmax=1,
                extent=(left, right, bottom, top))
    axes.add_collection(PathCollection([outline.transformed(Affine2D().scale(1 / fitted.pixel))], facecolor="none",
                                       edgecolor=style.OUTLINE, linewidth=0.8))
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)


def label(name, accuracy):
    return (name if len(name) <= 14 else name[:13] + "…") + "\n" + percent(accuracy)


def draw(options):
    fitted = fit.FittedImage(options)
    grains, title = chosen(options, *readReport(options.report))
    lines = math.ceil(len(grains) / COLUMNS)
    cell = style.LARGEST_WIDTH / COLUMNS
    figure, panels = plt.subplots(lines, COLUMNS, figsize=(style.LARGEST_WIDTH, 0.4 + lines * (cell + 0.25)), squeeze=False,
                                  layout="constrained")
    figure.get_layout_engine().set(w_pad=0.04, h_pad=0.03, wspace=0, hspace=0)
    for axes in panels.flat:
        axes.set_axis_off()
        axes.set_aspect("equal")
    for axes, (name, accuracy) in zip(panels.flat, grains):
        if name not in fitted.outlines:
            raise PlotError(f"{options.report}: grain '{name}' is not in {options.placement}")
        cutOut(axes, fitted, fitted.outlines[name])
        axes.set_title(label(name, accuracy), fontsize=7, loc="center", y=-0.02, va="top", pad=0)
    figure.suptitle(title + ", each at a scale of its own", x=0.02, ha="left", fontsize=10)
    return figure
