"""Fitted outlines over the image they come from.

The placement file has the columns id,x,y and, if wanted, angle: name of the template, its centroid
from the lower left corner of the image in the unit of the templates (y upwards), counter-clockwise turn
[rad].
"""

import csv

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PathCollection
from matplotlib.transforms import Affine2D

import style
from plotError import PlotError
from templateFile import readTemplates


def addOptions(parser):
    parser.add_argument("image", metavar="<image>")
    parser.add_argument("-templates", required=True, metavar="<chesil>", help="the fitted grains")
    parser.add_argument("-placement", required=True, metavar="<csv>", help="where they lie in the image")
    parser.add_argument("-scale", type=float, metavar="<m per pixel>",
                        help="needed if the templates are in metres")


def readPlacement(path):
    """[(name of the template, x, y, angle)]"""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    try:
        placements = [
            (row["id"], float(row["x"]), float(row["y"]), float(row.get("angle") or 0)) for row in rows
        ]
    except (KeyError, TypeError, ValueError) as error:
        raise PlotError(f"{path}: needs the columns id,x,y[,angle] ({error!r})") from None
    if not placements:
        raise PlotError(f"{path}: places no grain")
    return placements


def placedOutlines(templates, placements, placementFile):
    outlines = []
    for name, x, y, angle in placements:
        if name not in templates:
            raise PlotError(f"{placementFile}: grain '{name}' is not among the templates")
        outlines.append(templates[name].transformed(Affine2D().rotate(angle).translate(x, y)))
    return outlines


def readImage(path):
    """Grey values from 0 (black) to 1."""
    try:
        image = plt.imread(path).astype(float)
    except (SyntaxError, ValueError) as error:
        raise PlotError(f"{path}: not an image that can be read ({error})") from None
    if image.ndim == 3:
        image = image[:, :, :3].mean(axis=2)
    return image / max(image.max(), 1e-9)


def draw(options):
    unit, templates = readTemplates(options.templates)
    if unit == "pixel":
        pixel, unit = 1.0, "pixel"
    elif options.scale:
        factor, unit = style.lengthUnit(options.scale * 1000)
        pixel = options.scale * factor
    else:
        raise PlotError(f"{options.templates}: is in metres, so -scale <m per pixel> is needed")
    toAxes = 1.0 if unit == "pixel" else pixel / options.scale

    image = readImage(options.image)
    size = np.array(image.shape[::-1]) * pixel
    outlines = placedOutlines(templates, readPlacement(options.placement), options.placement)

    figure, (axes,) = style.panels(1, size, tallest=6.0)
    axes.imshow(image, cmap=style.PHOTO, vmin=0, vmax=1, extent=(0, size[0], 0, size[1]))
    axes.add_collection(PathCollection(
        [outline.transformed(Affine2D().scale(toAxes)) for outline in outlines],
        facecolor=style.OUTLINE + "18", edgecolor=style.OUTLINE, linewidth=1.0,
    ))
    axes.set_title(f"{len(outlines)} fitted grain" + "s" * (len(outlines) != 1))
    style.placeLengthAxes(axes, unit)
    style.scaleBar(axes, unit)
    return figure
