#!/usr/bin/env python3
"""A room with vertical edges seen by a conic-mirror camera that looks up (paper 000), rendered with POV-Ray.

usage: conic_mirror_room.py CONFIG.json FOLDER [--clean] [--truth-only]
--clean keeps the images free of noise; --truth-only writes the tables and renders nothing.
A configuration with "odometry" adds columns with dead-reckoned poses to frames.csv.
"""
import json
import math
import os
import sys

import cv2
import numpy as np
from scenelib import *


def wall_pigment(kind, col, scale=0.35):
    if kind == "plain":
        return "pigment { %s }" % rgb(col)
    c2 = [max(0, c - 0.06) for c in col]
    if kind == "brick":
        return ("pigment { brick %s %s brick_size <%g,%g,%g> mortar %g }"
                % (rgb([c * 0.9 for c in col]), rgb(col), 0.24, 0.24, 0.08, 0.01))
    return "pigment { %s scale %g color_map { [0 %s] [1 %s] } }" % (kind, scale, rgb(c2), rgb(col))


PROUD = 0.001     # m that panels stand out of the wall


def azimuth(pose, point):
    return math.degrees(wrap(math.atan2(point[1] - pose[1], point[0] - pose[0]) - pose[2]))


def seen_azimuth(pose, end, front, other):
    """of a panel's end, which is on the wall, in front of it, or between: its outline is where the panel is widest"""
    on_wall, in_front = azimuth(pose, end), azimuth(pose, front)
    return in_front if wrapdeg(in_front - on_wall) * wrapdeg(on_wall - azimuth(pose, other)) > 0 else on_wall


def build(room):
    """returns pov text, landmarks (mapped), clutter (unmapped vertical edges), occluders, and of every end of a panel its front
    edge and the other end"""
    X, Y, Z = room["size"]
    o, lm, cl, segs, circs, fronts = [], [], [], [], [], {}
    W = room["walls"]     # order S(y=0) E(x=X) N(y=Y) W(x=0)
    t = 0.1
    o.append(box((-t, -t, -t), (X + t, 0, Z), wall_pigment(*W["S"])))
    o.append(box((X, -t, -t), (X + t, Y + t, Z), wall_pigment(*W["E"])))
    o.append(box((-t, Y, -t), (X + t, Y + t, Z), wall_pigment(*W["N"])))
    o.append(box((-t, -t, -t), (0, Y + t, Z), wall_pigment(*W["W"])))
    o.append(box((-t, -t, -t), (X + t, Y + t, 0), wall_pigment(*room["floor"])))
    o.append(box((-t, -t, Z), (X + t, Y + t, Z + t), "pigment{rgb 0.85}"))
    for i, c in enumerate([(0, 0), (X, 0), (X, Y), (0, Y)]):
        cl.append(("room_corner%d" % i, c))

    def on_wall(w, a, b, z0, z1, d):
        if w == "S": return (a, -0.01, z0), (b, d, z1), (a, 0), (b, 0)
        if w == "N": return (a, Y + 0.01, z0), (b, Y - d, z1), (a, Y), (b, Y)
        if w == "E": return (X + 0.01, a, z0), (X - d, b, z1), (X, a), (X, b)
        return (-0.01, a, z0), (d, b, z1), (0, a), (0, b)
    for p in room["panels"]:      # doors, boards, posters: nearly flush with the wall
        lo, hi, e0, e1 = on_wall(p["wall"], p["a"], p["b"], p["z0"], p["z1"], PROUD)
        o.append(box(lo, hi, wall_pigment(p.get("tex", "plain"), p["col"])))
        dst = lm if p.get("mapped", True) else cl
        dst.append((p["name"] + "_a", e0)); dst.append((p["name"] + "_b", e1))
        begin = (lo[0], hi[1]) if p["wall"] in "SN" else (hi[0], lo[1])
        fronts[p["name"] + "_a"], fronts[p["name"] + "_b"] = (begin, e1), (hi[:2], e0)
    for b in room["boxes"]:       # cabinets, pillars: footprint + height
        x0, y0, x1, y1 = b["rect"]
        o.append(box((x0, y0, b.get("z0", -0.01)), (x1, y1, b["h"]), wall_pigment(b.get("tex", "plain"), b["col"])))
        segs += rect_edges(x0, y0, x1, y1)
        for i, c in enumerate([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]):
            dst = lm if i in b["mapped_corners"] else cl
            dst.append(("%s_%d" % (b["name"], i), c))
    for c in room.get("cylinders", []):   # people / bins: silhouettes that belong to no map edge
        o.append("cylinder { %s %s %g pigment { %s } finish{WALLF} }\n"
                 % (v3((*c["c"], 0)), v3((*c["c"], c["h"])), c["r"], rgb(c["col"])))
        circs.append((c["c"], c["r"]))
    # baseboard (horizontal clutter)
    if room.get("baseboard", True):
        o.append(box((0, 0, 0), (X, 0.008, 0.08), "pigment{rgb <0.25,0.18,0.12>}"))
        o.append(box((0, Y, 0), (X, Y - 0.008, 0.08), "pigment{rgb <0.25,0.18,0.12>}"))
    for l in room["lights"]:
        o.append(light(l["pos"], l.get("power", 1), l.get("col", [1, 1, 1]), l.get("fade"), l.get("soft", 0)))
    return "".join(o), lm, cl, segs, circs, fronts


def mirror(cam, pose):
    """conic mirror + black holder plate, camera pinhole on the axis below it"""
    x, y, th = pose
    al = math.radians(cam["cone_half_angle_deg"])
    d, zc = cam["apex_distance"], cam["pinhole_height"]
    tp = math.tan(math.radians(cam["rim_phi_deg"]))
    t = d * tp / (math.tan(al) - tp)         # cone height
    R = t * math.tan(al)
    # optional mounting error of the mirror axis with respect to the optical axis, robot frame
    ox, oy = cam.get("mirror_offset", [0, 0])
    wx, wy = x + ox * math.cos(th) - oy * math.sin(th), y + ox * math.sin(th) + oy * math.cos(th)
    za = zc + d
    if cam.get("ball"):       # a polished ball instead: azimuths are exact as well, but its rim shows what is beside it
        s = ("sphere { %s %g no_shadow pigment{rgb 0} finish{ambient 0 diffuse 0 specular 0 reflection{%g}} }\n"
             % (v3((wx, wy, zc + 0.05 / math.sin(math.radians(cam["rim_phi_deg"])))), 0.05, cam.get("reflectivity", 0.9)))
        return s, 0.05
    s = ("cone { %s 0 %s %g open no_shadow pigment{rgb 0} finish{ambient 0 diffuse 0 specular 0 reflection{%g}} }\n"
         % (v3((wx, wy, za)), v3((wx, wy, za + t)), R, cam.get("reflectivity", 0.9)))
    if cam.get("plate", True):
        s += ("disc { %s <0,0,1> %g no_shadow pigment{rgb 0.01} finish{ambient 0.3 diffuse 0.1} }\n"
              % (v3((wx, wy, za + t + 0.025)), (d + t + 0.025) * 0.85))   # raised: must not shade the rim's upward view
    s += ("cylinder { %s %s 0.012 no_shadow pigment{rgb 0.02} finish{ambient 0.2 diffuse 0.3} }\n"
          % (v3((x, y, zc - 0.06)), v3((x, y, zc - 0.004))))
    g = cam.get("glass_tube")
    if g:
        s += ("difference { cylinder { %s %s %g } cylinder { %s %s %g } no_shadow hollow "
              "pigment{rgbt <0.98,1,0.99,1>} finish{ambient 0 diffuse 0 reflection{0.0,1.0 fresnel} conserve_energy} interior{ior 1.5} }\n"
              % (v3((x, y, zc - 0.05)), v3((x, y, za + t)), g["radius"],
                 v3((x, y, zc - 0.06)), v3((x, y, za + t + 0.01)), g["radius"] - g["wall"]))
    return s, R


def main():
    cfg = json.load(open(sys.argv[1])); out = sys.argv[2]; clean = "--clean" in sys.argv; truth_only = "--truth-only" in sys.argv
    os.makedirs(out, exist_ok=True)
    room, cam = cfg["room"], cfg["camera"]
    base, lm, cl, segs, circs, fronts = build(room)
    amb, dif = room.get("ambient", 0.3), room.get("diffuse", 0.65)
    W, H = cam["width"], cam["height"]
    frames, obs = [], []
    odometry = dead_reckoning(cfg["poses"], cfg["odometry"], seed_of(cfg["name"], "odometry")) if "odometry" in cfg else None
    for k, (x, y, thd) in enumerate(cfg["poses"]):
        th = math.radians(thd)
        m = th + math.radians(cam.get("mount_yaw_deg", 0.0))
        right = (math.cos(m), math.sin(m), 0)
        down = (-math.sin(m), math.cos(m), 0)       # image v axis = camera-frame +y
        up = tuple(-c for c in down)
        forward, tilt = (0, 0, 1), math.radians(cam.get("camera_tilt_deg", 0.0))
        if tilt:      # of the camera alone, towards the image's u axis; the mirror stays upright
            a, b = np.array(forward), np.array(right)
            forward, right = math.cos(tilt) * a + math.sin(tilt) * b, math.cos(tilt) * b - math.sin(tilt) * a
        mir, R = mirror(cam, (x, y, th))
        pov = (header() + pinhole((x, y, cam["pinhole_height"]), forward, right, up, W, H,
                                  cam["fx"], cam["fy"], cam["cx"], cam["cy"]) + base + mir)
        pov = wallf(pov, amb, dif)
        name = "%s_%02d" % (cfg["name"], k)
        png = os.path.join(out, name + "_clean.png")
        keep = os.path.join(out, name + ".pov") if k == 0 else None
        fn = name + ".jpg"
        if not truth_only:
            render(pov, W, H, png, keep_pov=keep)
            img = cv2.imread(png)
            if not clean:
                os.remove(png)
            img = degrade(img, cfg["noise"], seed_of(cfg["name"], k))
            if cam.get("gray", True):
                img = cv2.cvtColor(img, cv2.COLOR_BGR2GRAY)
                cv2.imwrite(os.path.join(out, fn), img, [cv2.IMWRITE_JPEG_QUALITY, 95])
            else:
                save(img, os.path.join(out, fn), 94)
        fr = {"frame": k, "image": fn, "x_m": x, "y_m": y, "heading_deg": thd}
        if odometry:
            fr.update(zip(("odometry_x_m", "odometry_y_m", "odometry_heading_deg"), odometry[k]))
        frames.append(fr)
        for mapped, lst in ((1, lm), (0, cl)):
            for nm, c in lst:
                dx, dy = c[0] - x, c[1] - y
                az = wrapdeg(seen_azimuth((x, y, th), c, *fronts[nm]) if nm in fronts else azimuth((x, y, th), c))
                vis = not any(seg_hit((x, y), c, a, b) for a, b in segs) and \
                    not any(circ_hit((x, y), c, cc, rr) for cc, rr in circs)
                # a corner of a box seen "through" its own box: midpoint test just before the corner
                obs.append({"frame": k, "feature": nm, "mapped": mapped, "fx_m": float(c[0]), "fy_m": float(c[1]),
                            "azimuth_deg": az, "range_m": math.hypot(dx, dy), "visible": int(vis)})
        for ci, (cc, rr) in enumerate(circs):     # silhouette tangents of round objects
            dd = math.hypot(cc[0] - x, cc[1] - y); b0 = math.atan2(cc[1] - y, cc[0] - x)
            for sgn, nm in ((1, "l"), (-1, "r")):
                az = wrapdeg(math.degrees(wrap(b0 + sgn * math.asin(rr / dd) - th)))
                p = (x + dd * math.cos(b0 + sgn * math.asin(rr / dd)), y + dd * math.sin(b0 + sgn * math.asin(rr / dd)))
                vis = not any(seg_hit((x, y), p, a, b) for a, b in segs)
                obs.append({"frame": k, "feature": "cyl%d_%s" % (ci, nm), "mapped": 0, "fx_m": p[0], "fy_m": p[1],
                            "azimuth_deg": az, "range_m": dd, "visible": int(vis)})
        print(name, flush=True)
    write_csv(os.path.join(out, "frames.csv"), frames)
    write_csv(os.path.join(out, "observations.csv"), obs)
    write_csv(os.path.join(out, "map.csv"), [{"id": i, "name": n, "x_m": float(c[0]), "y_m": float(c[1])} for i, (n, c) in enumerate(lm)])
    cam = dict(cam); cam["mirror_rim_radius_m"] = R
    json.dump({"scene": "A", "name": cfg["name"], "camera": cam, "noise": cfg["noise"]}, open(os.path.join(out, "camera.json"), "w"), indent=1)


main()
