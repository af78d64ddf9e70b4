#!/usr/bin/env python3
"""live_replay.py carries every column of a recording of CSV files. Usage: live_replay.py SOURCE"""
import json
import pathlib
import subprocess
import sys
import tempfile

FILES = {
    "odometry.csv": "t,x,y,phi_deg\n0,0,0,0\n0.2,0.1,0,2\n",
    "sensors.csv": "sensor,x,y,z,yaw_deg\ncamera,0.2,0,1.1,90\n",
    "detections.csv": "t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m,yaw_deg,std_yaw_deg,"
                      "other_yaw_deg,other_std_yaw_deg,other_weight\n"
                      "0.1,camera,7,tag,12.5,,1,,170,2,-150,3,0.25\n"
                      "0.1,camera,,,,3.5,,0.1,,,,,\n",
}
EXPECTED = [
    {"t": 0.0, "odometry": [0, 0, 0]},
    {"t": 0.1, "sensor": "camera", "mount": [0.2, 0, 90], "height_m": 1.1, "detections": [
        {"id": 7, "category": "tag", "bearing_deg": 12.5, "std_bearing_deg": 1, "yaw_deg": 170, "std_yaw_deg": 2,
         "other_yaw_deg": -150, "other_std_yaw_deg": 3, "other_weight": 0.25},
        {"range_m": 3.5, "std_range_m": 0.1}]},
    {"t": 0.2, "odometry": [0.1, 0, 2]},
]

program = pathlib.Path(sys.argv[1]) / "apps/landmark-localization/live_replay.py"
with tempfile.TemporaryDirectory() as folder:
    for name, text in FILES.items():
        (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
    replay = subprocess.run([sys.executable, program, folder, "100"], capture_output=True, text=True, check=True)
lines = [json.loads(line) for line in replay.stdout.splitlines()]
if lines != EXPECTED:
    sys.exit(f"expected {EXPECTED}\n     got {lines}")
