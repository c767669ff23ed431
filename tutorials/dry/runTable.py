"""What the scripts that compare runs with the paper share: last values of measures over seeds, and a table of them."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "applications/utilities/chesilPlot"))
from ensemble import column, readRun  # noqa: E402,F401


def cases(pattern):
    found = sorted(Path("runs").glob(pattern))
    if not found:
        sys.exit(f"no run runs/{pattern}: Allrun first")
    return found


def last(case, measure, name):
    heads, columns = readRun(str(case), measure)
    return column(str(case), heads, columns, name)[0][-1]


# When pressing on all sides ends and loading begins, tools.sh [s]
CONSOLIDATION = 2.0


class Table:
    """CSV: name, mean, least and most over the runs, number of runs, what the paper says."""

    def __init__(self):
        print("name,mean,least,most,runs,paper")

    def add(self, name, values, paper=""):
        values = np.asarray(values, dtype=float)
        print(f"{name},{values.mean():.6g},{values.min():.6g},{values.max():.6g},{len(values)},{paper}", flush=True)
