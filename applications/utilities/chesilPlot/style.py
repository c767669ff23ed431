"""The house style of all pictures: colours, sizes, and the small helpers that keep them alike."""

import math

import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.font_manager import FontProperties
from mpl_toolkits.axes_grid1.anchored_artists import AnchoredSizeBar

from plotError import PlotError

# Okabe & Ito (2008), distinguishable with every kind of colour vision; yellow left out, too pale for lines
SERIES_COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
SERIES_MARKERS = ["o", "s", "^", "D", "v", "P", "X"]

INK = "#2E2E2E"
FAINT_INK = "#8C8C8C"
GRID = "#E4E4E4"
GRAIN_FILL = "#DCC296"
GRAIN_EDGE = "#5A4630"
PALE_GRAIN = "#F6F1E7"
WALL = "#4A4A4A"
OUTLINE = "#D55E00"

# From light to dark, even in lightness, so that they also read in grey
SAND = LinearSegmentedColormap.from_list("sand", ["#F3E6CB", "#DDBD88", "#BE915E", "#91653F", "#644330"])
WATER = LinearSegmentedColormap.from_list("water", ["#F5FAFC", "#C3E0EC", "#7DBAD4", "#3A86B0", "#17507F", "#0B2748"])
PHOTO = LinearSegmentedColormap.from_list("photo", ["#B7AFA2", "#FFFFFF"])

LARGEST_WIDTH = 9.0  # inches


def apply():
    plt.rcParams.update({
        "figure.dpi": 150,
        "savefig.dpi": 150,
        "savefig.facecolor": "white",
        "font.family": "sans-serif",
        "font.size": 9,
        "axes.titlesize": 10,
        "axes.titlelocation": "left",
        "axes.titlepad": 8,
        "axes.labelsize": 9,
        "axes.labelcolor": INK,
        "axes.edgecolor": FAINT_INK,
        "axes.linewidth": 0.6,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": False,
        "grid.color": GRID,
        "grid.linewidth": 0.6,
        "text.color": INK,
        "xtick.color": FAINT_INK,
        "ytick.color": FAINT_INK,
        "xtick.labelcolor": INK,
        "ytick.labelcolor": INK,
        "xtick.labelsize": 8,
        "ytick.labelsize": 8,
        "xtick.major.width": 0.6,
        "ytick.major.width": 0.6,
        "lines.linewidth": 1.5,
        "lines.markersize": 4.5,
        "legend.frameon": False,
        "legend.fontsize": 8.5,
        "svg.fonttype": "none",
    })


def save(figure, path):
    try:
        figure.savefig(path, bbox_inches="tight", pad_inches=0.12)
    except ValueError as error:
        raise PlotError(f"{path}: {error}") from None
    plt.close(figure)


# --- lengths -------------------------------------------------------------------------------------

def lengthUnit(extent):
    """(factor, name) of the unit in which a length of `extent` metres reads well."""
    for factor, name in ((1.0, "m"), (1e3, "mm"), (1e6, "µm")):
        if extent * factor >= 1.0:
            return factor, name
    return 1e6, "µm"


def niceLength(length):
    """The largest of 1, 2, 5 times a power of ten that is not above `length`."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1, 2, 5) if step * power <= length * (1 + 1e-9))


def scaleBar(axes, unit):
    """A bar of a round length above the right end of the axes, where it can hide nothing."""
    left, right = axes.get_xlim()
    length = niceLength(0.3 * (right - left))
    axes.add_artist(AnchoredSizeBar(
        axes.transData, length, f"{length:g} {unit}", loc="lower right", bbox_to_anchor=(1, 1),
        bbox_transform=axes.transAxes, label_top=True, size_vertical=0, sep=3, pad=0, borderpad=0.5,
        color=INK, frameon=False, fontproperties=FontProperties(size=8),
    ))


# --- things in a scene ---------------------------------------------------------------------------

def show(axes, low, high):
    """The region from corner to corner, with room for the stroke of a wall on its edge."""
    margin = 0.008 * max(high - low)
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)


def placeLengthAxes(axes, unit, labelled=True):
    """Equal scales, few ticks, coordinates with their unit."""
    axes.set_aspect("equal")
    axes.locator_params(nbins=5, steps=[1, 2, 5, 10])
    axes.set_xlabel(f"x [{unit}]")
    if labelled:
        axes.set_ylabel(f"y [{unit}]")
    axes.tick_params(labelleft=labelled)


def drawGrains(axes, outlines, **colours):
    """Closed outlines; colours as of matplotlib's PolyCollection."""
    colours.setdefault("edgecolor", GRAIN_EDGE)
    return axes.add_collection(PolyCollection(outlines, linewidth=0.6, zorder=3, **colours))


def drawWalls(axes, polylines):
    if polylines:
        axes.spines[:].set_visible(False)  # they would run beside the walls
    axes.add_collection(LineCollection(polylines, colors=WALL, linewidths=1.6, capstyle="round", zorder=4))


def colourBar(drawn, axes, label):
    """As high as the axes it stands beside."""
    inch = axes.figure.dpi / axes.bbox.width  # in widths of the axes
    bar = axes.figure.colorbar(drawn, cax=axes.inset_axes([1 + 0.2 * inch, 0, 0.13 * inch, 1]), label=label)
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=2)
    return bar


def panels(count, extent, tallest=4.6):
    """A row of panels for scenes of the same extent (width, height); (figure, list of axes)."""
    aspect = extent[1] / extent[0]
    width = min((LARGEST_WIDTH - 1.2) / count, tallest / aspect)
    figure, axes = plt.subplots(1, count, figsize=(width * count + 1.2, width * aspect + 0.9),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    return figure, list(axes[0])
