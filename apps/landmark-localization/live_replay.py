#!/usr/bin/env python3
"""Writes a recording of three CSV files as the lines that `landmark-localization --live` reads, at the pace it was made.

live_replay.py FOLDER [SPEED]    FOLDER holds odometry.csv (poses or velocities) and detections.csv, see
                                 apps/dataset2rawlog/README.md; SPEED times real time, default 1
"""
import csv
import json
import sys
import time


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def detection(row):
    numbers = ("bearing_deg", "range_m", "std_bearing_deg", "std_range_m")
    found = {key: float(row[key]) for key in numbers if row.get(key)}
    return found | ({"id": int(row["id"])} if row["id"] else {}) | ({"category": row["category"]} if row["category"] else {})


folder, speed = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 1
lines, readings = [], {}
for row in rows(folder + "/odometry.csv"):
    motion = ("velocity", ("v", "omega_deg_s")) if "v" in row else ("odometry", ("x", "y", "phi_deg"))
    lines.append({"t": float(row["t"]), motion[0]: [float(row[key]) for key in motion[1]]})
for row in rows(folder + "/detections.csv"):
    readings.setdefault((float(row["t"]), row["sensor"]), []).append(detection(row))
for (t, sensor), detections in readings.items():
    lines.append({"t": t, "sensor": sensor, "detections": detections})
lines.sort(key=lambda line: line["t"])
start, began = lines[0]["t"], time.monotonic()
for line in lines:
    time.sleep(max(0, (line["t"] - start) / speed - (time.monotonic() - began)))
    print(json.dumps(line), flush=True)
