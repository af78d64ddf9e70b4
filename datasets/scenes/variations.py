#!/usr/bin/env python3
"""Variations of the scenes: rooms, fields, paint, light, blur, noise and errors of the mirror drawn at random from seeds.

usage: variations.py FOLDER [NAME...] [--seed N]    renders FOLDER/NAME for every name that begins like one of NAME
A scene is rendered once, free of noise, to FOLDER/scenes; variations that differ by the camera only share it.
score_variations.py compares what images2rawlog measures with the truth.
"""
import json
import math
import os
import random
import shutil
import subprocess
import sys

import cv2
from scenelib import degrade, save, seed_of

HERE = os.path.dirname(os.path.abspath(__file__))
GENERATOR = {"conic": "conic_mirror_room", "movis": "movis_field", "stereo": "stereo_goal_field"}

# name: scene, camera. A scene is what the generator is told, a camera what happens to the image afterwards.
DIM = {"gain": 0.3, "blur": 1.2, "read": 2.5, "quality": 80, "subsampling": 2}
VARIATIONS = {
    # a room per seed, mirror and camera exact or not
    "conic_plain": ({}, {}), "conic_blur16": ({}, {"blur": 1.6}), "conic_blur24": ({}, {"blur": 2.4}),
    "conic_dim": ({}, {"gain": 0.4, "read": 3}), "conic_noise": ({}, {"read": 7}), "conic_jpeg": ({}, {"quality": 40}),
    "conic_bright": ({}, {"gain": 1.3}), "conic_vignette": ({}, {"vignette": 0.5}),
    "conic_other_plain": ({"room": 1}, {}), "conic_other_blur16": ({"room": 1}, {"blur": 1.6}),
    "conic_other_blur24": ({"room": 1}, {"blur": 2.4}), "conic_other_dim": ({"room": 1}, {"gain": 0.4, "read": 3}),
    "conic_people": ({"room": 2, "people": 3}, {}), "conic_people_blur16": ({"room": 2, "people": 3}, {"blur": 1.6}),
    "conic_tilt": ({"room": 3, "camera_tilt_deg": 1.0}, {}),
    "conic_tilt_blur16": ({"room": 3, "camera_tilt_deg": 1.0}, {"blur": 1.6}),
    "conic_offset": ({"room": 4, "mirror_offset": [0.0009, -0.0004]}, {}),
    "conic_offset_blur16": ({"room": 4, "mirror_offset": [0.0009, -0.0004]}, {"blur": 1.6}),
    "conic_no_plate": ({"room": 5, "plate": False}, {}), "conic_no_plate_blur16": ({"room": 5, "plate": False}, {"blur": 1.6}),
    "conic_ball": ({"room": 6, "ball": True}, {}), "conic_ball_blur16": ({"room": 6, "ball": True}, {"blur": 1.6}),
    "conic_ball_people": ({"room": 7, "ball": True, "people": 3}, {}),
    # half a field with poles and ball
    "movis_plain": ({}, {}), "movis_blur": ({}, {"blur": 1.6}), "movis_noise": ({}, {"read": 6}),
    "movis_dim": ({}, {"gain": 0.4}), "movis_dim_blur_jpeg": ({}, DIM), "movis_jpeg": ({}, {"quality": 60, "subsampling": 2}),
    "movis_cast": ({}, {"cast": [0.75, 1, 1.15]}), "movis_vignette": ({}, {"vignette": 0.4}),
    "movis_bright": ({}, {"gain": 1.25}), "movis_coarse": ({}, {"quality": 30, "subsampling": 2}),
    "movis_covered": ({"field": 1, "cover": [0.33, 1.3]}, {}),
    "movis_covered_low": ({"field": 1, "cover": [0.33, 0.5]}, {}),
    "movis_covered_half": ({"field": 2, "cover": [0.5, 1.6]}, {}),
    "movis_covered_dim": ({"field": 1, "cover": [0.33, 1.3]}, {"gain": 0.4}),
    "movis_other": ({"field": 3}, {}), "movis_other_dim_blur_jpeg": ({"field": 3}, DIM),
    "movis_other_blur": ({"field": 3}, {"blur": 1.6}), "movis_other_cast": ({"field": 3}, {"cast": [1.2, 1, 0.8]}),
    "movis_hall": ({"field": 4, "lights": 0.5}, {}), "movis_hall_dim": ({"field": 4, "lights": 0.5}, {"gain": 0.5}),
    # a field with goals
    "stereo_plain": ({}, {}), "stereo_blur": ({}, {"blur": 1.2}), "stereo_noise": ({}, {"read": 6}),
    "stereo_dim": ({}, {"gain": 0.4}), "stereo_dark": ({}, {"gain": 0.18}), "stereo_jpeg": ({}, {"quality": 60, "subsampling": 2}),
    "stereo_cast": ({}, {"cast": [0.75, 1, 1.15]}), "stereo_bright": ({}, {"gain": 1.25}),
    "stereo_white_sides": ({"field": 1, "goal_sides": "white"}, {}),
    "stereo_white_sides_blur": ({"field": 1, "goal_sides": "white"}, {"blur": 1.0}),
    "stereo_white_sides_dim": ({"field": 1, "goal_sides": "white"}, {"gain": 0.5}),
    "stereo_white_sides_other": ({"field": 2, "goal_sides": "white"}, {}),
    "stereo_white_sides_large": ({"field": 2, "goal_sides": "white", "size": 640}, {}),
    "stereo_gloss30": ({"field": 3, "gloss": 0.3}, {}), "stereo_mirror_floor": ({"field": 4, "gloss": 1.0}, {}),
    "stereo_mirror_floor_dim": ({"field": 4, "gloss": 1.0}, {"gain": 0.5}),
    "stereo_pale": ({"field": 5, "blue": [0.2, 0.3, 0.7], "yellow": [0.85, 0.75, 0.3]}, {}),
    "stereo_pale_cast": ({"field": 5, "blue": [0.2, 0.3, 0.7], "yellow": [0.85, 0.75, 0.3]}, {"cast": [0.8, 1, 1.1]}),
    "stereo_paler": ({"field": 6, "blue": [0.3, 0.42, 0.75], "yellow": [0.85, 0.72, 0.2]}, {}),
    "stereo_deep": ({"field": 7, "blue": [0.02, 0.06, 0.45], "yellow": [0.8, 0.5, 0.02]}, {}),
    "stereo_large": ({"size": 640}, {}),
}


def room(seed, people=0, **camera):
    r = random.Random(seed)
    X, Y = r.uniform(5, 7.5), r.uniform(4, 6)
    light = r.uniform(0.5, 0.85)

    def colour(a, b):
        return [round(r.uniform(a, b), 2) for _ in range(3)]
    walls = {k: [r.choice(["plain", "granite", "bumps", "brick"]), colour(light - 0.06, light + 0.06), r.uniform(0.15, 0.8)] for k in "SENW"}
    panels = []
    for w in "SENW":
        a, end = r.uniform(0.4, 1.2), X if w in "SN" else Y
        for i in range(3):
            b = min(end - 0.3, a + r.choice([0.12, 0.3, 0.6, 0.9, 1.3]))
            if b < a + 0.1:
                break
            panels.append({"name": "p%s%d" % (w, i), "wall": w, "a": round(a, 2), "b": round(b, 2), "z0": r.choice([0, 0, 0.4, 0.8]),
                           "z1": r.choice([2.1, 2.0, 1.7]), "col": colour(0.08, 0.6)})
            a = b + r.uniform(0.5, 1.8)
    boxes = []
    for i in range(2):
        x, y, w = r.uniform(1.0, X - 1.5), (0.9 if i else Y - 1.3) + r.uniform(-.2, .2), r.uniform(0.25, 0.5)
        boxes.append({"name": "b%d" % i, "rect": [x, y, x + w, y + w], "h": r.choice([1.8, 2.7]), "col": colour(0.2, 0.6), "mapped_corners": [0, 1, 2, 3]})
    poses, persons = [], []
    while len(poses) < 4 or len(persons) < people:
        x, y = r.uniform(0.9, X - 0.9), r.uniform(1.4, Y - 1.7)
        if any(b["rect"][0] - .5 < x < b["rect"][2] + .5 and b["rect"][1] - .5 < y < b["rect"][3] + .5 for b in boxes):
            continue
        if len(persons) < people:
            persons.append({"c": [x, y], "r": 0.2, "h": 1.75, "col": colour(0.05, 0.5)})
        elif all(math.hypot(x - p["c"][0], y - p["c"][1]) > 0.6 for p in persons):
            poses.append([round(x, 2), round(y, 2), round(r.uniform(-180, 180), 1)])
    cam = {"width": 640, "height": 480, "fx": 500 + r.uniform(0, 40), "fy": 495.0, "cx": 320 + r.uniform(-8, 8), "cy": 238 + r.uniform(-6, 6),
           "cone_half_angle_deg": r.choice([50.0, 52.5, 54.0]), "apex_distance": 0.06, "rim_phi_deg": 24.0,
           "pinhole_height": r.uniform(0.5, 0.95), "mount_yaw_deg": 0.0, "reflectivity": 0.9, "gray": True, **camera}
    lamps = [{"pos": [X * a, Y * b, 2.6], "power": p, "fade": 3.0, "soft": 0.5} for a, b, p in ((.25, .3, .75), (.75, .75, .65), (.75, .2, .45))]
    return {"camera": cam, "poses": poses, "noise": {"blur": 0.6, "read": 2.0, "shot": 3.0, "vignette": 0.15},
            "room": {"size": [X, Y, 2.7], "ambient": 0.3, "diffuse": 0.65, "walls": walls, "floor": ["granite", colour(0.3, 0.5), 0.3],
                     "panels": panels, "boxes": boxes, "cylinders": persons, "lights": lamps}}


def half_field(seed, cover=None, lights=1.0):
    r = random.Random(seed)
    cfg = json.load(open(HERE + "/movis_field.json"))
    del cfg["odometry"], cfg["camera"]["mount_yaw_error_deg"]
    cfg["camera"].update(width=480, height=480, fx=630.0, fy=630.0, centers=[[239.5 + r.uniform(-3, 3) for _ in "uv"] for _ in "123"])
    f = cfg["field"]
    f["ball"] = [r.uniform(-0.8, 0.8), r.uniform(2.2, 3.2)]
    for lamp in f["lights"]:
        lamp["power"] *= lights * r.uniform(0.8, 1.2)
        lamp["col"] = [1, r.uniform(0.9, 1), r.uniform(0.75, 1)]
    for wall in f["hall"]:
        wall["col"] = [r.uniform(0.3, 0.7) for _ in "rgb"]
    cfg["poses"] = []
    for k in range(3):
        x, y = r.uniform(-1.5, 1.5), r.uniform(-0.5, 1.5)
        robots = []
        for sign in (-1, 1) if cover else ():       # before each pole, its edge inside the pole's outline
            far = math.hypot(sign * f["Fw"] - x, f["Fd"] - y)
            az, share, rad = math.atan2(f["Fd"] - y, sign * f["Fw"] - x), r.uniform(0.6, 0.8), 0.12
            edge = (1 - 2 * cover[0]) * f["pole_radius"] * share + rad
            side = r.choice([-1, 1]) * edge
            robots.append([x + far * share * math.cos(az) - side * math.sin(az), y + far * share * math.sin(az) + side * math.cos(az), rad, cover[1],
                           r.choice([[0.04] * 3, [0.15, 0.16, 0.25], [0.4, 0.35, 0.3], [0.6, 0.1, 0.1]])])
        cfg["poses"].append(["%02d" % k, round(x, 3), round(y, 3), round(r.uniform(-60, 60), 1), robots])
    return cfg


def goals(seed, size=320, **field):
    r = random.Random(seed)
    cfg = json.load(open(HERE + "/stereo_goal_field.json"))
    cfg.pop("odometry", None)
    cfg["stereo"].update(width=size, height=size * 3 // 4)
    cfg["noise"] = {"blur": 0.5 * size / 320, "read": 2.0, "shot": 3.5, "vignette": 0.12}
    cfg["supersample"] = [8 * 320 // size, 2]    # upright edges are to be where the truth has them
    cfg["field"].update(field)
    for lamp in cfg["field"]["lights"]:
        lamp["power"] *= r.uniform(0.8, 1.2)
    X, Y = cfg["field"]["X"], cfg["field"]["Y"]
    cfg["poses"] = []
    while len(cfg["poses"]) < 6:
        x, y = r.uniform(0.25, X - 0.25), r.uniform(0.2, Y - 0.2)
        h = math.degrees(math.atan2(Y / 2 - y, r.choice([0, X]) - x)) + r.uniform(-15, 15)
        cfg["poses"].append({"pose": [round(x, 3), round(y, 3), round(h, 1)]})
    return cfg


MAKE = {"conic": room, "movis": half_field, "stereo": goals}


def scene_of(folder, sensor, options, seed):
    """the folder of a scene free of noise, rendered when it is not there"""
    options = dict(options)
    cfg = MAKE[sensor](100 * seed + options.pop("room", options.pop("field", 0)), **options)
    cfg["name"] = sensor
    cfg["quality"] = 95
    out = os.path.join(folder, "scenes", "%s_%08x" % (sensor, seed_of(json.dumps(cfg, sort_keys=True))))
    if not os.path.exists(out + "/done"):
        os.makedirs(out, exist_ok=True)
        json.dump(cfg, open(out + "/config.json", "w"))
        subprocess.run([sys.executable, "%s/%s.py" % (HERE, GENERATOR[sensor]), out + "/config.json", out, "--clean"], check=True, stdout=subprocess.DEVNULL)
        open(out + "/done", "w").close()
    return out, cfg


def make(folder, name, seed):
    options, effects = VARIATIONS[name]
    sensor = name.split("_")[0]
    scene, cfg = scene_of(folder, sensor, options, seed)
    out = os.path.join(folder, name)
    os.makedirs(out, exist_ok=True)
    for file in os.listdir(scene):
        if file.endswith(("_clean.png",)):
            image = degrade(cv2.imread(os.path.join(scene, file)), {**cfg["noise"], **effects}, seed_of(name, file))
            if sensor == "conic":
                image = cv2.cvtColor(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), cv2.COLOR_GRAY2BGR)
            save(image, os.path.join(out, file[:-10] + ".jpg"), effects.get("quality", 94), effects.get("subsampling", 0))
        elif file.endswith((".csv", "camera.json")):
            shutil.copy(os.path.join(scene, file), out)
    camera = json.load(open(out + "/camera.json"))
    if sensor == "conic" and ("tilt" in name or "offset" in name):
        for key in ("camera_tilt_deg", "mirror_offset"):      # what nobody tells
            camera["camera"].pop(key, None)
        json.dump(camera, open(out + "/camera.json", "w"), indent=1)


if __name__ == "__main__":
    arguments = sys.argv[1:]
    seed = 1
    if "--seed" in arguments:
        at = arguments.index("--seed")
        seed = int(arguments[at + 1])
        del arguments[at:at + 2]
    for name in VARIATIONS:
        if len(arguments) < 2 or name.startswith(tuple(arguments[1:])):
            make(arguments[0], name, seed)
            print(name, flush=True)
