"""Whole logs: run landmark-localization, and read what a run has left."""

import csv
import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import _native


@dataclass
class Run:
    """What a run left in its folder.

    summary       the dict of summary.json
    steps         per method a dict of arrays: t, pose (n, 3), covariance (n, 2, 2) of the position, std_phi, verdict
    trajectories  per method an array (n, 4): t, x, y, phi
    biases        per systematic error a dict of arrays: t, mean, std (units of biases.csv)
    """

    folder: Path
    summary: dict
    steps: dict
    trajectories: dict
    biases: dict


def _numbers(rows, key):
    return np.array([float(row[key]) if row[key] else math.nan for row in rows])


def _by(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return groups


def _table(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def _steps(rows):
    xx, xy, yy = (_numbers(rows, key) for key in ("cxx", "cxy", "cyy"))
    return {
        "t": _numbers(rows, "t"),
        "pose": np.stack([_numbers(rows, "x"), _numbers(rows, "y"), np.deg2rad(_numbers(rows, "phi_deg"))], axis=1),
        "covariance": np.stack([xx, xy, xy, yy], axis=1).reshape(-1, 2, 2),
        "std_phi": np.sqrt(_numbers(rows, "cpp")),
        "verdict": np.array([row["verdict"] for row in rows]),
    }


def _trajectory(path):
    rows = np.loadtxt(path, ndmin=2)
    if rows.size == 0:
        return np.empty((0, 4))
    phi = 2 * np.arctan2(rows[:, 6], rows[:, 7])
    return np.column_stack([rows[:, 0], rows[:, 1], rows[:, 2], np.arctan2(np.sin(phi), np.cos(phi))])


def load_run(folder):
    """Reads the folder of a run (or of one trial of a study). Raises FileNotFoundError where there is none."""
    folder = Path(folder)
    summary = json.loads((folder / "summary.json").read_text())
    prefix = "trajectory_"
    return Run(
        folder=folder,
        summary=summary,
        steps={name: _steps(rows) for name, rows in _by(_table(folder / "steps.csv"), "method").items()},
        trajectories={path.stem[len(prefix):]: _trajectory(path) for path in sorted(folder.glob(prefix + "*.tum"))},
        biases={
            name: {key: _numbers(rows, key) for key in ("t", "mean", "std")}
            for name, rows in _by(_table(folder / "biases.csv"), "bias").items()
        },
    )


def run(config, output, rawlog=None, map=None, ground_truth=None, overrides=None, options=()):
    """Runs landmark-localization over a log and returns load_run(output).

    config, rawlog, map, ground_truth: files; overrides: dict of "Section.key" to value; options: further arguments of the
    app. Raises InputError with the app's message when the run fails; a run that ends `lost` is a result.
    """
    arguments = [str(config)] + ([str(rawlog)] if rawlog else []) + ["-q", "-o", str(output)]
    for option, value in (("--map", map), ("--ground-truth", ground_truth)):
        if value:
            arguments += [option, str(value)]
    for key, value in (overrides or {}).items():
        arguments += ["--set", f"{key}={value}"]
    exit_code, _, errors = _native._run_app(arguments + [str(option) for option in options])
    if exit_code in (1, 2):
        raise _native.InputError(errors.strip())
    return load_run(output)
