"""How many neighbours grains have at the end of runs: mean share and extremes, a colour a group.

Takes the measure `coordination` of each run.
"""

import matplotlib.pyplot as plt
import numpy as np

import style
from ensemble import addGroups, column, groupsOf, readRun, title


def addOptions(parser):
    addGroups(parser)


def sharesOf(case):
    heads, columns = readRun(case, "coordination")
    names = [name for name, _ in heads if name.startswith("share")]
    return [column(case, heads, columns, name)[0][-1] for name in names]


def draw(options):
    groups = groupsOf(options)
    figure, axes = plt.subplots(figsize=(5.2, 3.2), layout="constrained")
    width = 0.8 / len(groups)
    last = 0
    for number, (label, cases) in enumerate(groups):
        shares = 100 * np.array([sharesOf(case) for case in cases])
        mean = shares.mean(axis=0)
        last = max(last, int(np.nonzero(mean)[0].max()))
        places = np.arange(len(mean)) + (number - (len(groups) - 1) / 2) * width
        errors = [mean - shares.min(axis=0), shares.max(axis=0) - mean]
        axes.bar(places, mean, width=width, color=style.SERIES_COLOURS[number], label=label, yerr=errors, ecolor=style.INK,
                 error_kw={"linewidth": 0.8, "capsize": 2})
    axes.set_xticks(range(len(mean)))
    axes.set_xlim(-0.6, last + 0.6)
    axes.set_xlabel("neighbours [-]")
    axes.set_ylabel("share of the grains [%]")
    axes.grid(True, axis="y")
    axes.set_axisbelow(True)
    axes.legend(loc="best")
    figure.suptitle(title(options, groups), x=0.02, ha="left", fontsize=10)
    return figure
