"""The files behind tests/record and tests/scoreboard: bars, values, and what the values were measured on.

    tests/bars/<topic>.csv               name,comparison,bound,unit,measuredBy,command,source
    tests/results/<machine>/<topic>.csv  name,value,unit,commit,code,date,command

"measuredBy" lists the paths (files or folders) whose change makes a value stale. "code" is the
fingerprint of these paths' content at the time of the measurement, so that a value that was measured
before the commit of the same code stays valid, and needs no history to be judged.
"""

import csv
import fcntl
import hashlib
import operator
import os
import platform
import re
import subprocess
from contextlib import contextmanager
from dataclasses import dataclass, fields
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
BARS = PROJECT / "tests/bars"
RESULTS = PROJECT / "tests/results"

COMPARISONS = {"<=": operator.le, "<": operator.lt, ">=": operator.ge, ">": operator.gt, "==": operator.eq}


class ScoreboardError(Exception):
    """What a user can mend; shown as one line."""


@dataclass
class Bar:
    name: str
    comparison: str
    bound: str
    unit: str
    measuredBy: str
    command: str
    source: str

    def isMetBy(self, value):
        return COMPARISONS[self.comparison](float(value), float(self.bound))


@dataclass
class Value:
    name: str
    value: str
    unit: str
    commit: str
    code: str
    date: str
    command: str


def readRows(path, rowType):
    """Rows of a CSV file by name; empty if there is no such file."""
    if not path.is_file():
        return {}
    columns = [field.name for field in fields(rowType)]
    rows = {}
    with open(path, newline="") as file:
        reader = csv.DictReader(file, strict=True)
        if reader.fieldnames != columns:
            raise ScoreboardError(f"{path}: the columns must be {','.join(columns)}")
        for row in reader:
            if None in row or None in row.values():
                raise ScoreboardError(f"{path}:{reader.line_num}: a row must have {len(columns)} columns")
            if row["name"] in rows:
                raise ScoreboardError(f"{path}:{reader.line_num}: second row of the name {row['name']}")
            rows[row["name"]] = rowType(**row)
    return rows


def topics():
    return sorted(path.stem for path in BARS.glob("*.csv"))


def readBars(topic):
    path = BARS / f"{topic}.csv"
    if not path.is_file():
        raise ScoreboardError(f"no topic '{topic}' (known: {' '.join(topics())})")
    bars = readRows(path, Bar)
    for bar in bars.values():
        if bar.comparison not in COMPARISONS:
            raise ScoreboardError(f"{path}: {bar.name}: comparison '{bar.comparison}', "
                                  f"must be one of {' '.join(COMPARISONS)}")
        float(bar.bound)
    return bars


def readValues(machine, topic):
    return readRows(RESULTS / machine / f"{topic}.csv", Value)


def writeValues(machine, topic, values):
    """Written aside, then renamed, so that an interrupted run leaves no half file."""
    path = RESULTS / machine / f"{topic}.csv"
    aside = path.with_suffix(".new")
    with open(aside, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([field.name for field in fields(Value)])
        for name in sorted(values):
            writer.writerow([getattr(values[name], field.name) for field in fields(Value)])
    aside.rename(path)


@contextmanager
def lockedResults(machine):
    """Tests that run side by side write one after the other."""
    folder = RESULTS / machine
    folder.mkdir(parents=True, exist_ok=True)
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)


def machineName():
    """Architecture, processor and cores, as in x86_64-amd-epyc-2; CHESIL_MACHINE overrides it."""
    if os.environ.get("CHESIL_MACHINE"):
        return os.environ["CHESIL_MACHINE"]
    model = "unknown"
    if os.path.exists("/proc/cpuinfo"):
        found = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
        model = found.group(1) if found else model
    model = re.sub(r"\((r|tm)\)|@.*|\bcpu\b|\bprocessor\b|\b\d+-core\b", " ", model.lower())
    slug = "-".join(re.findall(r"[a-z0-9]+", model))
    return f"{platform.machine()}-{slug}-{len(os.sched_getaffinity(0))}"


def git(*arguments):
    """What git prints, or None where there is no git or no repository."""
    try:
        run = subprocess.run(["git", "-C", str(PROJECT), *arguments], capture_output=True, text=True)
    except FileNotFoundError:
        return None
    return run.stdout if run.returncode == 0 else None


def commitName():
    """Short hash, with a + if the tree differs from it in more than results."""
    commit = git("rev-parse", "--short", "HEAD")
    if commit is None:
        return "none"
    changes = git("status", "--porcelain", "--", ".", ":!tests/results", ":!tests/benchmarks/results")
    return commit.strip() + ("+" if changes else "")


def fingerprint(paths):
    """Short hash of the content of all files under the paths, or None outside a git repository."""
    listed = git("ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *paths)
    if listed is None:
        return None
    digest = hashlib.sha1()
    for name in sorted(set(listed.split("\0")) - {""}):
        path = PROJECT / name
        if path.is_file():
            digest.update(name.encode() + b"\0" + hashlib.sha1(path.read_bytes()).digest())
    return digest.hexdigest()[:10]
