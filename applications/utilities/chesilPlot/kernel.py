"""The contact kernel on a packing: support calls, their mean by pair type, residual over iterations.

One or more CSV of the benchmark paperKernel, below each other in one picture; their header tells what they hold:
  counter,contact,paperMean,calls,pairs              histograms of support calls
  first,second,paper,counter,contact,separate,both,contactPairs,separatePairs   means by pair type
  method,iteration,low,median,high,worst,pairs       residual of the depth over support calls
paperMean and paper: the averages printed in the paper, 0 for none.
"""

import csv

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

import style
from plotError import PlotError

PAPER = style.SERIES_COLOURS[1]
MANY_CALLS = 40  # what takes more is drawn in the last bar
FLOOR = 1.8e-15  # residuals up to here are rounding: 8 epsilon


def addOptions(parser):
    parser.add_argument("files", nargs="+", metavar="<csv>")
    parser.add_argument("-title", metavar="<text>")


# --- input -----------------------------------------------------------------------------------------

def readTable(path):
    """(names of the columns, rows as dictionaries, numbers as floats)"""
    with open(path, newline="") as file:
        reader = csv.DictReader(line for line in file if not line.startswith("#"))
        rows = [{name: numberOrText(value) for name, value in row.items()} for row in reader]
    if not rows:
        raise PlotError(f"{path}: holds no rows")
    if any(None in row or None in row.values() for row in rows):
        raise PlotError(f"{path}: a row has not as many fields as the header")
    return tuple(reader.fieldnames), rows


def numberOrText(value):
    try:
        return float(value)
    except (TypeError, ValueError):
        return value


def groups(rows, *names):
    """{values of the named columns: rows}, in the order of the file."""
    found = {}
    for row in rows:
        key = tuple(row[name] for name in names)
        found.setdefault(key[0] if len(names) == 1 else key, []).append(row)
    return found


# --- histograms of support calls ---------------------------------------------------------------------

def drawHistogram(axes, rows, colour):
    calls = np.array([row["calls"] for row in rows])
    pairs = np.array([row["pairs"] for row in rows])
    mean = (calls * pairs).sum() / pairs.sum()
    axes.bar(np.minimum(calls, MANY_CALLS), 100 * pairs / pairs.sum(), width=0.8, color=colour, zorder=2)
    axes.axvline(mean, color=style.INK, linewidth=1.2, zorder=3)
    lines = [(f"mean {mean:.2f}", style.INK)]
    paper = rows[0]["paperMean"]
    if paper:
        axes.axvline(paper, color=PAPER, linewidth=1.2, linestyle=(0, (4, 2)), zorder=3)
        lines.append((f"paper {paper:.2f}", PAPER))
    for number, (line, ink) in enumerate(reversed(lines)):
        axes.annotate(line, (1, 1), xycoords="axes fraction", xytext=(-62 * number, 0), textcoords="offset points",
                      ha="right", va="bottom", fontsize=8.5, color=ink)


def drawCalls(figure, rows):
    """A row of panels for each counter: pairs that are separate, pairs in contact."""
    counters = groups(rows, "counter")
    panels = figure.subplots(len(counters), 2, sharex="col", squeeze=False)
    for rank, (counter, ofCounter) in enumerate(counters.items()):
        byContact = groups(ofCounter, "contact")
        for axes, contact in zip(panels[rank], (0.0, 1.0)):
            axes.margins(x=0.02)
            axes.grid(True, axis="y")
            axes.set_axisbelow(True)
            axes.xaxis.set_major_locator(MaxNLocator(integer=True, nbins=8))
            if contact in byContact:
                drawHistogram(axes, byContact[contact], style.SERIES_COLOURS[0])
            axes.annotate(counter, (0, 1), xycoords="axes fraction", va="bottom", fontsize=8.5)
        panels[rank][0].set_ylabel("pairs [%]")
    for axes, contact, name in zip(panels[0], (0.0, 1.0), ("separate", "in contact")):
        number = sum(row["pairs"] for row in next(iter(counters.values())) if row["contact"] == contact)
        axes.set_title(f"{name}: {number:.0f} pairs", pad=20)
    for axes in panels[-1]:
        axes.set_xlim(left=0)
        axes.set_xlabel("support calls of A − B in one query")


# --- means by pair type --------------------------------------------------------------------------------

def meansOf(types, counter, column):
    return [next(row[column] for row in ofType if row["counter"] == counter) for ofType in types.values()]


def drawPairTypes(figure, rows):
    """Bars of each pair type: the paper's mean, GJK's over all pairs and over those in contact, the engine's."""
    types = groups(rows, "first", "second")
    counters = list(groups(rows, "counter"))
    bars = [("paper (contact and separate)", PAPER, [ofType[0]["paper"] for ofType in types.values()])]
    colours = [style.SERIES_COLOURS[0], style.SERIES_COLOURS[4], style.SERIES_COLOURS[2], style.SERIES_COLOURS[3]]
    for column, name in (("both", "contact and separate"), ("contact", "contact")):
        bars.append((f"{counters[0]}, {name}", colours.pop(0), meansOf(types, counters[0], column)))
    for counter, colour in zip([counter for counter in counters if counter.startswith("engine")], colours):
        bars.append((f"{counter}, contact", colour, meansOf(types, counter, "contact")))

    axes = figure.subplots()
    width = 0.92 / len(bars)
    places = np.arange(len(types))
    for rank, (name, colour, values) in enumerate(bars):
        drawn = axes.bar(places + (rank - (len(bars) - 1) / 2) * width, values, 0.92 * width, color=colour, label=name)
        axes.bar_label(drawn, fmt="%.2f", fontsize=6.5, padding=1.5, color=style.INK)
    axes.set_xticks(places, ["–\n".join(kind) for kind in types])
    axes.tick_params(axis="x", length=0)
    axes.set_ylabel("mean support calls")
    axes.margins(x=0.01, y=0.1)
    axes.grid(True, axis="y")
    axes.set_axisbelow(True)
    axes.legend(ncol=len(bars), loc="lower left", bbox_to_anchor=(-0.01, 1.0), borderaxespad=0.2, columnspacing=1.0,
                handlelength=1.2, handletextpad=0.5)


# --- residual over iterations ----------------------------------------------------------------------------

def ordersAnIteration(iterations, residuals):
    """Decimal orders by which an iteration lowers the residual, fitted between the start and rounding."""
    inside = (residuals < 1e-2) & (residuals > 1e-14)
    if inside.sum() < 6:
        return None
    return -np.polyfit(iterations[inside], np.log10(residuals[inside]), 1)[0]


def drawCurve(axes, rows, number, label, band=True):
    names = ("iteration", "low", "median", "high")
    iterations, low, middle, high = (np.array([row[name] for row in rows]) for name in names)
    colour = style.SERIES_COLOURS[number % len(style.SERIES_COLOURS)]
    end = firstAtFloor(middle) + 1
    axes.semilogy(iterations[:end], middle[:end], color=colour, marker=style.SERIES_MARKERS[number], label=label)
    if band:
        axes.fill_between(iterations, low, high, color=colour, alpha=0.16, linewidth=0)
    return iterations, middle


def firstAtFloor(residuals):
    """Index of the first that is rounding, or of the last."""
    return int(np.argmax(residuals <= FLOOR)) if (residuals <= FLOOR).any() else len(residuals) - 1


def drawPaperSlope(axes, iterations, residuals):
    """Six orders in ten iterations, laid beside the first curve."""
    first = int(np.argmax(residuals < 1e-2))
    x = iterations[first] + np.array([0.0, 10.0])
    y = residuals[first] * np.array([1.0, 1e-6]) * 8
    axes.semilogy(x, y, color=style.INK, linewidth=1.1, linestyle=(0, (4, 2)), label="paper: 10⁻⁶ in 10 iterations")


def drawResiduals(figure, rows):
    """EPA on the left, Newton on the right over the EPA of the same pairs."""
    methods = groups(rows, "method")
    numbers = {method: rank for rank, method in enumerate(methods)}
    newton = [method for method in methods if "Newton" in method]
    epa = [method for method in methods if method not in newton]
    smooth = [method for method in epa if "smooth" in method]
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    # Those with a polygon end at an edge or not: a band would span all.
    for method in (method for method in epa if method not in smooth):
        first = method == epa[0]
        drawn = drawCurve(panels[0], methods[method], numbers[method], labelOf(methods[method]), band=first)
        if first:
            drawPaperSlope(panels[0], *drawn)
    for method in smooth + newton:
        drawCurve(panels[1], methods[method], numbers[method], labelOf(methods[method]))
    last = max(firstAtFloor(np.array([row["high"] for row in ofMethod])) for ofMethod in methods.values())
    panels[0].set_xlim(0, last + 2)
    panels[0].xaxis.set_major_locator(MaxNLocator(integer=True, nbins=8))
    for axes, title in zip(panels, ("EPA", "Newton's finish")):
        axes.set_title(title)
        axes.grid(True)
        axes.set_axisbelow(True)
        axes.axhline(FLOOR, color=style.FAINT_INK, linewidth=0.8)
        axes.set_xlabel("support calls of A − B after GJK (one an iteration)")
        axes.legend(loc="upper right")
    panels[0].annotate("rounding", (0.01, FLOOR), xycoords=("axes fraction", "data"), xytext=(0, -2), va="top",
                       textcoords="offset points", fontsize=7.5, color=style.FAINT_INK)
    panels[0].set_ylabel("residual of the depth over the pair's size [-]\n(median, band 10 to 90 %)")


def labelOf(rows):
    iterations, middle = (np.array([row[name] for row in rows]) for name in ("iteration", "median"))
    orders = ordersAnIteration(iterations, middle)
    name = rows[0]["method"]
    return f"{name}: ÷{10 ** orders:.1f} an iteration" if orders else name


# --- the picture -------------------------------------------------------------------------------------------

KINDS = {
    ("counter", "contact", "paperMean", "calls", "pairs"):
        (drawCalls, lambda rows: 0.9 + 1.35 * len(groups(rows, "counter"))),
    ("first", "second", "paper", "counter", "contact", "separate", "both", "contactPairs", "separatePairs"):
        (drawPairTypes, lambda rows: 2.9),
    ("method", "iteration", "low", "median", "high", "worst", "pairs"):
        (drawResiduals, lambda rows: 4.4),
}


def chooseKind(path):
    header, rows = readTable(path)
    if header not in KINDS:
        known = " | ".join(",".join(columns) for columns in KINDS)
        raise PlotError(f"{path}: header {','.join(header)}, must be one of {known}")
    return *KINDS[header], rows


def draw(options):
    parts = [chooseKind(path) for path in options.files]
    heights = [height(rows) for _, height, rows in parts]
    figure = plt.figure(figsize=(style.LARGEST_WIDTH, sum(heights)), layout="constrained")
    fields = figure.subfigures(len(parts), 1, height_ratios=heights, squeeze=False, hspace=0.04)[:, 0]
    for field, (drawPart, _, rows) in zip(fields, parts):
        drawPart(field, rows)
    if options.title:
        figure.suptitle(options.title, x=0.01, ha="left", fontsize=11)
    return figure
