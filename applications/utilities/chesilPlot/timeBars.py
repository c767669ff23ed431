"""Bars of run time, for a benchmark whose rows are things one can have rather than settings of one knob."""

import matplotlib.pyplot as plt

import style

THICKNESS = 0.8  # of a method's share of the height


def draw(comments, methods):
    """comments and methods as errorOverTime.readBenchmark gives them; one bar for each knob."""
    knobs = list(dict.fromkeys(knob for points in methods.values() for _, _, knob in points))
    figure, axes = plt.subplots(figsize=(6.4, 0.9 + 0.32 * len(methods)), layout="constrained")
    for row, points in enumerate(methods.values()):
        height = THICKNESS / len(points)
        for place, (time, _, knob) in enumerate(points):
            y = row + (place - (len(points) - 1) / 2) * height
            axes.barh(y, time, height, color=style.SERIES_COLOURS[knobs.index(knob)])
            shown = f"{time:.3g}" if time < 100 else f"{time:.0f}"
            axes.annotate(shown, (time, y), xytext=(3, 0), textcoords="offset points", va="center", fontsize=7.5)
    axes.set_yticks(range(len(methods)), list(methods))
    axes.invert_yaxis()
    axes.margins(x=0.1)
    axes.grid(True, axis="x")
    axes.set_axisbelow(True)
    axes.set_xlabel(comments.get("time", "time"))
    axes.set_title(comments.get("title", ""))
    samples = [plt.Rectangle((0, 0), 1, 1, color=style.SERIES_COLOURS[i]) for i in range(len(knobs))]
    axes.legend(samples, knobs, title=comments.get("knob"), loc="upper left", bbox_to_anchor=(1, 1))
    return figure
