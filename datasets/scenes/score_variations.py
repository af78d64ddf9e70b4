#!/usr/bin/env python3
"""What images2rawlog measures in the images of variations.py, beside the truth.

usage: score_variations.py IMAGES2RAWLOG FOLDER [NAME...]       one line per variation
"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np
from scenelib import wrap, wrapdeg

INI = {"conic": "conic-mirror", "movis": "movis", "stereo": "stereo"}
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")


def table(path):
    return list(csv.DictReader(open(path)))


def measure(binary, folder, sensor):
    with tempfile.TemporaryDirectory() as scratch:
        run = subprocess.run([binary, "%s/ini/images2rawlog/%s.ini" % (ROOT, INI[sensor]), "-i", folder, "-o", scratch + "/log.rawlog",
                              "--csv", scratch + "/log.csv"], capture_output=True, text=True)
        rows = table(scratch + "/log.csv") if os.path.exists(scratch + "/log.csv") else []
        return rows, [line for line in run.stderr.splitlines() if line]


def nees(errors):
    """of (error, stated): the mean, and that of the median over a chi-squared's of one degree of freedom"""
    shares = [(e / s) ** 2 for e, s in errors]
    return "nees %.2f (median %.2f)" % (np.mean(shares), np.median(shares) / 0.455) if shares else ""


def rms(values):
    return math.sqrt(np.mean(np.square(values))) if len(values) else float("nan")


def conic(folder, rows):
    truth, seen = {}, {}
    for r in table(folder + "/observations.csv"):
        if r["visible"] == "1":
            truth.setdefault(r["frame"], []).append((float(r["azimuth_deg"]), r["mapped"] == "1"))
    for r in rows:
        seen.setdefault(r["frame"], []).append((float(r["azimuth_deg"]), float(r["std_azimuth_deg"])))
    total = found = strange = 0
    errors = []
    for frame, edges in truth.items():
        here = seen.get(frame, [])
        for azimuth, mapped in edges:
            if not mapped:
                continue
            total += 1
            near = min(here, key=lambda s: abs(wrapdeg(s[0] - azimuth)), default=None)
            beside = [abs(wrapdeg(e[0] - azimuth)) for e in edges]
            if near is None or abs(wrapdeg(near[0] - azimuth)) > (0.5 if sum(b < 1.8 for b in beside) > 1 else 1):
                continue
            found += 1
            if sum(b < 2.5 for b in beside) == 1:
                errors.append((wrapdeg(near[0] - azimuth), near[1]))
        strange += sum(all(abs(wrapdeg(e[0] - s[0])) > 1 for e in edges) for s in here)
    return "edges %d of %d, error %.3f deg, %s, %.1f unexplained per image" % (
        found, total, rms([e for e, _ in errors]), nees(errors), strange / max(1, len(truth)))


def fit(residuals, start):
    """Gauss-Newton on numeric derivatives"""
    x = np.array(start, float)
    for _ in range(20):
        r = residuals(x)
        J = np.column_stack([(residuals(x + d) - r) / 1e-6 for d in np.eye(len(x)) * 1e-6])
        step = np.linalg.lstsq(J, -r, rcond=None)[0]
        x += step
        if np.abs(step).max() < 1e-9:
            break
    return x


def movis(folder, rows):
    camera = json.load(open(folder + "/camera.json"))
    L, f = camera["camera"]["L"], camera["field"]
    mounts = {"M1": (-math.sqrt(3) / 2 * L, L / 2), "M2": (math.sqrt(3) / 2 * L, L / 2), "M3": (0.0, -L)}
    poles = {"p": (-f["Fw"], f["Fd"]), "q": (f["Fw"], f["Fd"])}
    frames = {r["frame"]: r for r in table(folder + "/frames.csv")}
    covered = {(r["frame"], "M" + r["camera"], r["object"]): float(r.get("covered", 0)) for r in table(folder + "/observations.csv")}
    usable = sum(r["blocked_by_own_mirror"] == "0" and float(r["hidden_by_body"]) < 0.05 and float(r.get("covered", 0)) < 0.9
                 for r in table(folder + "/observations.csv"))
    errors, hidden, balls, selfs = [], [], [], []
    for frame, truth in frames.items():
        here = [r for r in rows if r["frame"] == frame]
        for r in here:
            at = [float(truth["%s_%sr_m" % (r["label"], a)]) for a in "xy"]
            m = mounts[r["sensor"]]
            error = wrapdeg(float(r["azimuth_deg"]) - math.degrees(math.atan2(-(at[0] - m[0]), at[1] - m[1])))
            pair = (error, float(r["std_azimuth_deg"]))
            (hidden if covered[frame, r["sensor"], r["label"]] > 0.02 else errors).append(pair)

        def bearing(m, at):     # counter-clockwise from the robot's y axis
            return math.atan2(-(at[0] - m[0]), at[1] - m[1])

        def off(x, r):
            return wrap(bearing(mounts[r["sensor"]], x) - math.radians(float(r["azimuth_deg"]))) / math.radians(float(r["std_azimuth_deg"]))
        ball = [r for r in here if r["label"] == "ball"]
        at = np.array([float(truth["ball_xr_m"]), float(truth["ball_yr_m"])])
        if len(ball) > 1:
            balls.append(np.hypot(*(fit(lambda x: np.array([off(x, r) for r in ball]), at) - at)))
        seen = [r for r in here if r["label"] in poles]
        if len({r["label"] for r in seen}) == 2 and len(seen) > 2:
            def residuals(x):
                c, s = math.cos(x[2]), math.sin(x[2])
                def robot(p): return ((p[0] - x[0]) * c + (p[1] - x[1]) * s, -(p[0] - x[0]) * s + (p[1] - x[1]) * c)
                return np.array([off(robot(poles[r["label"]]), r) for r in seen])
            pose = [float(truth["x_m"]), float(truth["y_m"]), math.radians(float(truth["heading_deg"]))]
            selfs.append(np.hypot(*(fit(residuals, pose) - pose)[:2]))
    text = "objects %d of %d, error %.3f deg, %s" % (len(errors) + len(hidden), usable, rms([e for e, _ in errors]), nees(errors))
    if hidden:
        text += "; covered %d, %.3f deg, %s, largest %.1f deviations" % (
            len(hidden), rms([e for e, _ in hidden]), nees(hidden), max(abs(e / s) for e, s in hidden))
    return text + "; ball %.1f cm (worst %.1f), self %.1f cm (worst %.1f) of %d" % (
        *(100 * f(v) if v else float("nan") for v in (balls, selfs) for f in (np.mean, max)), len(selfs))


def stereo(folder, rows):
    width = json.load(open(folder + "/camera.json"))["stereo"]["width"]
    truth = {(r["frame"], r["landmark"]): r for r in table(folder + "/observations.csv")}
    visible = sum(r["visible_both"] == "1" for r in truth.values())
    right, wrong, ranges, bearings = 0, 0, [], []
    for r in rows:
        if r["label"] in "LTX":
            continue
        t = truth[r["frame"], r["label"]]
        off = float(r["range_m"]) - float(t["range_left_m"])
        if abs(float(r["u_left"]) - float(t["uL"])) < 4 * width / 320 and abs(off) < 0.12 * float(t["range_left_m"]):
            right += 1
            ranges.append((off, float(r["std_range_m"])))
        else:
            wrong += 1
    points = {}
    for t in table(folder + "/line_points.csv"):
        points.setdefault(t["frame"], []).append((t["point"][0], float(t["uL"])))
    lines = [r for r in rows if r["label"] in "LTX"]
    strange = sum(not any(kind == r["label"] and abs(u - float(r["u_left"])) < 6 * width / 320 for kind, u in points.get(r["frame"], [])) for r in lines)
    return "corners %d of %d, %d wrong, range %.1f cm, %s; %d line landmarks, %d strange" % (
        right, visible, wrong, 100 * rms([e for e, _ in ranges]), nees(ranges), len(lines), strange)


if __name__ == "__main__":
    binary, folder, *names = sys.argv[1:]
    for name in sorted(os.listdir(folder)):
        sensor = name.split("_")[0]
        if sensor not in INI or names and not name.startswith(tuple(names)):
            continue
        found, notes = measure(binary, os.path.join(folder, name), sensor)
        print("%-26s %s%s" % (name, globals()[sensor](os.path.join(folder, name), found), "; %d lines: %s" % (len(notes), notes[0][:70]) if notes else ""), flush=True)
