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
    """{name: outline where it lies in the image}"""
    outlines = {}
    for name, x, y, angle in placements:
        if name not in templates:
            raise PlotError(f"{placementFile}: grain '{name}' is not among the templates")
        outlines[name] = templates[name].transformed(Affine2D().rotate(angle).translate(x, y))
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


class FittedImage:
    """The image and the outlines over it, in one unit: pixels, or a length that reads well.

    image: grey values; pixel: its size; size: width and height; outlines: {name: outline in the image}
    """

    def __init__(self, options):
        unit, templates = readTemplates(options.templates)
        if unit == "pixel":
            self.unit, self.pixel, toUnit = "pixel", 1.0, 1.0
        elif options.scale:
            toUnit, self.unit = style.lengthUnit(options.scale * 1000)
            self.pixel = options.scale * toUnit
        else:
            raise PlotError(f"{options.templates}: is in metres, so -scale <m per pixel> is needed")
        self.image = readImage(options.image)
        self.size = np.array(self.image.shape[::-1]) * self.pixel
        placed = placedOutlines(templates, readPlacement(options.placement), options.placement)
        self.outlines = {name: outline.transformed(Affine2D().scale(toUnit)) for name, outline in placed.items()}


def draw(options):
    fitted = FittedImage(options)
    figure, (axes,) = style.panels(1, fitted.size, tallest=6.0)
    axes.imshow(fitted.image, cmap=style.PHOTO, vmin=0, vmax=1, extent=(0, fitted.size[0], 0, fitted.size[1]))
    axes.add_collection(PathCollection(
        list(fitted.outlines.values()), facecolor=style.OUTLINE + "18", edgecolor=style.OUTLINE, linewidth=1.0,
    ))
    axes.set_title(f"{len(fitted.outlines)} fitted grain" + "s" * (len(fitted.outlines) != 1))
    style.placeLengthAxes(axes, fitted.unit)
    style.scaleBar(axes, fitted.unit)
    return figure
