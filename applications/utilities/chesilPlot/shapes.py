"""Sheet of described grains: outline, largest circle inside, smallest around, long axis and the main descriptors.

The tables are those that chesilDescribe writes, with -outlines.
"""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Polygon

import style
from descriptorTable import readDescriptors, readOutlines
from plotError import PlotError

COLUMNS = 6
MARGIN = 1.08  # of a cell around the circle in it


def addOptions(parser):
    parser.add_argument("table", metavar="<csv>")
    parser.add_argument("-outlines", required=True, metavar="<csv>", help="the outlines that were described")
    parser.add_argument("-most", type=int, default=30, metavar="<number>", help="grains to show, in the table's order (default: 30)")


def drawGrain(axes, columns, index, outline):
    def circle(kind, **look):
        centre = columns[kind + "X"][index], columns[kind + "Y"][index]
        axes.add_patch(Circle(centre, columns[kind + "Radius"][index], fill=False, linewidth=0.9, **look))
        return np.array(centre)

    axes.add_patch(Polygon(outline, facecolor=style.GRAIN_FILL, edgecolor=style.GRAIN_EDGE, linewidth=0.9))
    circle("inscribed", edgecolor=style.SERIES_COLOURS[0])
    middle = circle("circumscribed", edgecolor=style.OUTLINE)
    angle = math.radians(columns["elongationAngle"][index])
    along = np.array([math.cos(angle), math.sin(angle)])
    reach = (outline - middle) @ along
    across = np.mean((outline - middle) @ np.array([-along[1], along[0]])) * np.array([-along[1], along[0]])
    ends = np.array([middle + across + reach.min() * along, middle + across + reach.max() * along])
    axes.plot(ends[:, 0], ends[:, 1], color=style.FAINT_INK, linewidth=0.9, linestyle="--")
    half = MARGIN * columns["circumscribedRadius"][index]
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)


def caption(columns, index, name):
    short = name if len(name) <= 16 else name[:15] + "…"
    return (f"{short}\nelongation {columns['elongation'][index]:.2f}, sphericity {columns['sphericity'][index]:.2f}\n"
            f"roundness {columns['roundness'][index]:.2f}, of corners {columns['cornerRoundness'][index]:.2f}")


def draw(options):
    if options.most < 1:
        raise PlotError(f"-most: {options.most}; expected at least 1")
    columns, names, _ = readDescriptors(options.table)
    outlines = readOutlines(options.outlines)
    shown = names[:options.most]
    lines = math.ceil(len(shown) / COLUMNS)
    cell = style.LARGEST_WIDTH / COLUMNS
    figure, panels = plt.subplots(lines, COLUMNS, figsize=(style.LARGEST_WIDTH, 0.4 + lines * (cell + 0.4)), squeeze=False,
                                  layout="constrained")
    figure.get_layout_engine().set(w_pad=0.05, h_pad=0.04, wspace=0, hspace=0)
    for axes in panels.flat:
        axes.set_axis_off()
        axes.set_aspect("equal")
    for index, (axes, name) in enumerate(zip(panels.flat, shown)):
        if name not in outlines:
            raise PlotError(f"{options.table}: grain '{name}' is not in {options.outlines}")
        drawGrain(axes, columns, index, outlines[name])
        axes.set_title(caption(columns, index, name), fontsize=6.5, loc="center", y=-0.02, va="top", pad=0)
    title = f"The first {len(shown)} of {len(names)} grains" if len(shown) < len(names) else f"All {len(names)} grains"
    figure.suptitle(title + ": largest circle inside, smallest around, long axis; each at a scale of its own", x=0.02, ha="left",
                    fontsize=10)
    return figure
