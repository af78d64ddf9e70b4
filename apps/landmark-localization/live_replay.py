#!/usr/bin/env python3
"""Writes a recording as the lines that `landmark-localization --live` reads, at the pace it was made.

live_replay.py RECORDING [SPEED]   RECORDING: lines that `landmark-localization --lines` wrote of a log (- for standard
                                   input), or a folder of CSV files, see apps/dataset2rawlog/README.md; SPEED times real
                                   time, default 1
"""
import csv
import json
import os
import sys
import time


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def detection(row):
    """All columns have the name of their field, so that none is lost."""
    types = {"id": int, "category": str}
    return {key: types.get(key, float)(text) for key, text in row.items() if text and key not in ("t", "sensor")}


def lines_of_csv(folder):
    lines, readings, mounts = [], {}, {}
    for row in rows(folder + "/odometry.csv"):
        motion = ("velocity", ("v", "omega_deg_s")) if "v" in row else ("odometry", ("x", "y", "phi_deg"))
        lines.append({"t": float(row["t"]), motion[0]: [float(row[key]) for key in motion[1]]})
    if os.path.exists(folder + "/sensors.csv"):
        for row in rows(folder + "/sensors.csv"):
            mounts[row["sensor"]] = {"mount": [float(row[key]) for key in ("x", "y", "yaw_deg")], "height_m": float(row["z"])}
    for row in rows(folder + "/detections.csv"):
        readings.setdefault((float(row["t"]), row["sensor"]), []).append(detection(row))
    for (t, sensor), detections in readings.items():
        lines.append({"t": t, "sensor": sensor} | mounts.get(sensor, {}) | {"detections": detections})
    return [json.dumps(line) for line in sorted(lines, key=lambda line: line["t"])]


recording, speed = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 1
if os.path.isdir(recording):
    lines = lines_of_csv(recording)
else:
    lines = sys.stdin if recording == "-" else open(recording)
start, began = None, time.monotonic()
for line in lines:
    t = json.loads(line)["t"]
    start = t if start is None else start
    time.sleep(max(0, (t - start) / speed - (time.monotonic() - began)))
    print(line.strip(), flush=True)
