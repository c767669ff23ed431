"""The verification of the dry engine: computed points over the lines of theory, a panel a case.

The CSV of chesilValidation_dry: panel,xLabel,yLabel,series,x,computed,theory; a row without computed is theory alone.
"""

import matplotlib.pyplot as plt

import style
from kernel import groups, readTable
from plotError import PlotError

COLUMNS = ("panel", "xLabel", "yLabel", "series", "x", "computed", "theory")
# Errors fall by orders of magnitude; what is no gain at all has no logarithm.
LOGARITHMIC = ("Restitution over time step", "Largest gain in grazing impacts")
PANELS_A_ROW = 3


def addOptions(parser):
    parser.add_argument("file", metavar="<csv>")


def drawPanel(axes, name, rows):
    colours = style.SERIES_COLOURS
    series = groups(rows, "series")
    for number, (label, points) in enumerate(series.items()):
        colour = colours[number % len(colours)]
        marker = style.SERIES_MARKERS[number % len(style.SERIES_MARKERS)]
        points = sorted(points, key=lambda point: point["x"])
        axes.plot([point["x"] for point in points], [point["theory"] for point in points], color=colour, linewidth=0.9, zorder=2)
        computed = [point for point in points if point["computed"] != ""]
        axes.plot([point["x"] for point in computed], [point["computed"] for point in computed], marker, color=colour, fillstyle="full" if number < len(colours) else "none",
                  label=label, zorder=3,
                  markersize=3.6 if len(series) > 4 else 5 - 1.2 * number)
    if name in LOGARITHMIC:
        axes.loglog()
    axes.set_title(name)
    axes.set_xlabel(rows[0]["xLabel"])
    axes.set_ylabel(rows[0]["yLabel"])
    axes.grid(True)
    axes.set_axisbelow(True)
    if len(series) > 4:
        axes.legend(fontsize=6.5, loc="center left", bbox_to_anchor=(1.0, 0.5), handletextpad=0.2)
    elif len(series) > 1:
        # Above all points, in room made for it.
        low, high = axes.get_ylim()
        axes.set_ylim(low, high * 3 if name in LOGARITHMIC else high + 0.15 * (high - low))
        axes.legend(fontsize=7, loc="upper left", ncol=len(series), handlelength=1.3, handletextpad=0.2, columnspacing=0.6, borderaxespad=0.1)


def draw(options):
    header, rows = readTable(options.file)
    if header != COLUMNS:
        raise PlotError(f"{options.file}: header {','.join(header)}, must be {','.join(COLUMNS)}")
    panels = groups(rows, "panel")
    # The one with the long legend takes two places at the end.
    names = sorted(panels, key=lambda name: name == LOGARITHMIC[1])
    lines = -(-(len(names) + 1) // PANELS_A_ROW)
    figure = plt.figure(figsize=(style.LARGEST_WIDTH, 2.5 * lines), layout="constrained")
    grid = figure.add_gridspec(lines, PANELS_A_ROW)
    for place, name in enumerate(names):
        row, column = divmod(place, PANELS_A_ROW)
        last = place == len(names) - 1
        drawPanel(figure.add_subplot(grid[row, column:] if last else grid[row, column]), name, panels[name])
    return figure
