#!/usr/bin/env python3
"""From the images of variations.py to poses, by the shipped configurations, beside the truth.

usage: localize_variations.py BINARIES FOLDER [NAME...]     one line per variation, and what is `ok` and wrong
BINARIES is the folder of images2rawlog and landmark-localization, e.g. build/bin. The pairs of the stereo camera are no
drive: every pair is localized by itself, from goal corners and markings, by closed forms.
"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

from scenelib import wrapdeg
from score_variations import INI, ROOT

# configuration, more arguments, and the error [m, deg] from which on `ok` is wrong
CHAIN = {"conic": ("conic-mirror", [], 0.5, 10), "movis": ("movis-frames", [], 0.5, 15),
         "stereo": ("stereo-goal", ["--set", "LocalizationExperiment.independent_frames=true"], 0.15, 15)}


def run(command):
    outcome = subprocess.run(command, capture_output=True, text=True)
    return outcome.returncode, (outcome.stderr.strip().splitlines() or [""])[-1]


def localize(binaries, scene, sensor, scratch):
    """rows of steps.csv, the verdict and the truth; or why there are none"""
    log, (config, more, _, _) = scratch + "/log", CHAIN[sensor]
    code, line = run([binaries + "/images2rawlog", "%s/ini/images2rawlog/%s.ini" % (ROOT, INI[sensor]), "-i", scene, "-o", log + ".rawlog", "-q"])
    if code:
        return line
    code, line = run([binaries + "/landmark-localization", "%s/ini/landmark-localization/%s.ini" % (ROOT, config), log + ".rawlog", "--map", log + "_map.csv",
                      "--ground-truth", log + "_ground_truth.tum", "-o", scratch + "/run", "-q", *more])
    if code not in (0, 3):
        return line
    truth = [[float(v) for v in line.split()] for line in open(log + "_ground_truth.tum")]
    return list(csv.DictReader(open(scratch + "/run/steps.csv"))), json.load(open(scratch + "/run/summary.json"))["verdict"], truth


def errors_of(rows, truth):
    """by method: (time, error [m], error [deg], verdict) of every estimate"""
    methods = {}
    for row in rows:
        if row["method"] == "odometry" or row["method"].startswith("oracle_") or not row["x"]:
            continue
        at = min(truth, key=lambda pose: abs(pose[0] - float(row["t"])))
        turned = wrapdeg(float(row["phi_deg"]) - math.degrees(2 * math.atan2(at[6], at[7]))) if row["phi_deg"] else 0
        methods.setdefault(row["method"], []).append((float(row["t"]), math.hypot(float(row["x"]) - at[1], float(row["y"]) - at[2]), turned, row["verdict"]))
    return methods


def text_of(method, estimates, limit, limit_deg):
    errors = sorted(e[1] for e in estimates)
    ok = [e for e in estimates if e[3] == "ok"]
    wrong = ["t %g: %.2f m %.0f deg" % e[:3] for e in ok if e[1] > limit or abs(e[2]) > limit_deg]
    text = "%s %d estimates, %d ok, %.3f m (worst %.3f)" % (method, len(estimates), len(ok), errors[len(errors) // 2], errors[-1])
    return text + (", OK AND WRONG " + ", ".join(wrong) if wrong else "")


def main():
    binaries, folder, *names = sys.argv[1:]
    for name in sorted(os.listdir(folder)):
        sensor = name.split("_")[0]
        if sensor not in CHAIN or names and not name.startswith(tuple(names)):
            continue
        with tempfile.TemporaryDirectory() as scratch:
            outcome = localize(binaries, os.path.join(folder, name), sensor, scratch)
        if isinstance(outcome, str):
            print("%-26s %s" % (name, outcome), flush=True)
            continue
        rows, verdict, truth = outcome
        texts = [text_of(method, estimates, *CHAIN[sensor][2:]) for method, estimates in errors_of(rows, truth).items()]
        print("%-26s %d frames, verdict %s; %s" % (name, len(truth), verdict, "; ".join(texts)), flush=True)


if __name__ == "__main__":
    main()
