#!/usr/bin/env python3
"""Half a robot soccer field with two corner poles and a ball, seen by three hyperbolic-mirror cameras at the corners of
an equilateral triangle (paper 001), rendered with POV-Ray.

usage: movis_field.py CONFIG.json FOLDER [--clean] [--truth-only]
--clean keeps the images free of noise; --truth-only writes the tables and renders nothing.
A configuration with "odometry" adds columns with dead-reckoned poses to frames.csv.

Robot frame of the paper: x right, y forward; heading is the angle of its x axis in the field. Mirror foci at
M1 (-sqrt3/2 L, L/2), M2 (+sqrt3/2 L, L/2), M3 (0, -L); the azimuth theta of a camera counts counter-clockwise from the
direction to the middle of the triangle. "mount_yaw_error_deg" turns cameras against that; it stays out of camera.json.
"""
import json
import math
import os
import sys

import cv2
import numpy as np
from scenelib import *

S3 = math.sqrt(3.0)


def robots(all):
    """others on the field: upright cylinders x, y, radius, height [, colour], black unless said"""
    return "".join("cylinder { %s %s %g pigment{%s} finish{WALLF} }\n"
                   % (v3((r[0], r[1], 0)), v3((r[0], r[1], r[3])), r[2], rgb(r[4] if len(r) > 4 else [0.04] * 3)) for r in all)


def covered(eye, centre, radius, others):
    """share of an object's width behind others that are nearer, seen from eye"""
    def span(c, r):
        d = math.hypot(c[0] - eye[0], c[1] - eye[1])
        return d, math.atan2(c[1] - eye[1], c[0] - eye[0]), math.asin(min(1.0, r / d))
    d, middle, half = span(centre, radius)
    hidden = np.zeros(200, bool)
    at = np.linspace(-half, half, len(hidden))
    for r in others:
        near, az, reach = span(r, r[2])
        if near < d:
            hidden |= np.abs(at - wrap(az - middle)) < reach
    return float(hidden.mean())


def field(c):
    Fw, Fd = c["Fw"], c["Fd"]
    o = []
    g = c["green"]
    o.append("plane { <0,0,1>, 0 pigment { granite scale 0.4 color_map { [0 %s] [1 %s] } } finish{WALLF} }\n"
             % (rgb(g), rgb([v * 0.75 for v in g])))
    lw = 0.125 if not "line_width" in c else c["line_width"]

    def line(x0, y0, x1, y1):
        o.append(box((x0, y0, -0.01), (x1, y1, 0.001), "pigment{rgb 0.9}"))
    line(-Fw, Fd - lw, Fw, Fd); line(-Fw, -Fd, -Fw + lw, Fd); line(Fw - lw, -Fd, Fw, Fd)
    line(-Fw, -lw / 2, Fw, lw / 2)
    pw, pd = c.get("penalty", [1.5, 0.8])
    line(-pw, Fd - pd - lw, pw, Fd - pd); line(-pw, Fd - pd, -pw + lw, Fd); line(pw - lw, Fd - pd, pw, Fd)
    cr = c.get("circle", 0.8)
    o.append("difference { cylinder { <0,0,-0.01> <0,0,0.001> %g } cylinder { <0,0,-0.02> <0,0,0.002> %g } pigment{rgb 0.9} finish{WALLF} }\n" % (cr, cr - lw))
    gw, gd, gh = c.get("goal", [2.0, 0.5, 0.9])
    gc = c["goal_col"]
    o.append(box((-gw / 2, Fd, 0), (-gw / 2 - 0.05, Fd + gd, gh), "pigment{rgb 0.85}"))
    o.append(box((gw / 2, Fd, 0), (gw / 2 + 0.05, Fd + gd, gh), "pigment{rgb 0.85}"))
    o.append(box((-gw / 2, Fd + 0.001, 0), (-gw / 2 + 0.004, Fd + gd, gh), "pigment{%s}" % rgb(gc)))
    o.append(box((gw / 2, Fd + 0.001, 0), (gw / 2 - 0.004, Fd + gd, gh), "pigment{%s}" % rgb(gc)))
    o.append(box((-gw / 2, Fd + gd, 0), (gw / 2, Fd + gd + 0.05, gh), "pigment{%s}" % rgb(gc)))
    pr, ph = c["pole_radius"], c["pole_height"]
    Y, B = c["yellow"], c["blue"]
    for sx, bands in ((-1, (Y, B, Y)), (1, (B, Y, B))):
        for i, col in enumerate(bands):
            o.append("cylinder { %s %s %g pigment{%s} finish{WALLF} }\n"
                     % (v3((sx * Fw, Fd, ph * i / 3)), v3((sx * Fw, Fd, ph * (i + 1) / 3)), pr, rgb(col)))
    b = c["ball"]
    o.append("sphere { %s %g pigment{%s} finish{WALLF phong 0.3 phong_size 20} }\n"
             .replace("finish{WALLF phong 0.3 phong_size 20}", "finish{WALLF}") % (v3((b[0], b[1], c["ball_radius"])), c["ball_radius"], rgb(c["orange"])))
    for h in c.get("hall", []):      # hall walls / spectators far behind the field
        o.append(box(h["lo"], h["hi"], "pigment{ %s }" % (rgb(h["col"]) if "tex" not in h else
                 "%s scale %g color_map{[0 %s][1 %s]}" % (h["tex"], h.get("scale", 0.5), rgb(h["col"]), rgb([v * 0.7 for v in h["col"]])))))
    for l in c["lights"]:
        o.append(light(l["pos"], l.get("power", 1), l.get("col", [1, 1, 1]), l.get("fade"), l.get("soft", 0)))
    return "".join(o)


def mirror_unit(cam, px, py, own):
    """hyperboloid of two sheets, upper sheet; focus F at (px,py,zF), pinhole at F - 2c e_z."""
    a, b, R, zF = cam["a"], cam["b"], cam["rim_radius"], cam["focus_height"]
    c = math.sqrt(a * a + b * b)
    z0 = zF - c                         # centre of the hyperboloid
    zt = a * math.sqrt(1 + R * R / (b * b))
    s = ("quadric { <%.9g,%.9g,%.9g>,<0,0,0>,<0,0,0>,1 clipped_by { box { <-1,-1,%.9g> <1,1,%.9g> } } translate %s no_shadow "
         "pigment{rgb 0} finish{ambient 0 diffuse 0 reflection{%g}} }\n"
         % (1 / (b * b), 1 / (b * b), -1 / (a * a), a * 0.5, zt, v3((px, py, z0)), cam.get("reflectivity", 0.9)))
    # holder: short stem plus (own mirror) a raised black plate that hides the hall beyond the rim
    # without shading the rays that reach the rim from above the horizon
    s += ("cylinder { %s %s %g no_shadow pigment{rgb 0.02} finish{ambient 0.3 diffuse 0.2} }\n"
          % (v3((px, py, z0 + zt + 1e-4)), v3((px, py, z0 + zt + 0.02)), R * (0.95 if own else 1.1)))
    if own:
        s += ("disc { %s <0,0,1> %g no_shadow pigment{rgb 0.02} finish{ambient 0.3 diffuse 0.2} }\n"
              % (v3((px, py, z0 + zt + 0.021)), (2 * c + 0.04) * 0.62))
    s += ("cylinder { %s %s 0.022 no_shadow pigment{rgb 0.03} finish{ambient 0.2 diffuse 0.3} }\n"
          % (v3((px, py, 0.45)), v3((px, py, zF - 2 * c - 0.003))))
    return s, zF - 2 * c


def main():
    cfg = json.load(open(sys.argv[1])); out = sys.argv[2]; clean = "--clean" in sys.argv; truth_only = "--truth-only" in sys.argv
    os.makedirs(out, exist_ok=True)
    f, cam = cfg["field"], cfg["camera"]
    amb, dif = f.get("ambient", 0.3), f.get("diffuse", 0.65)
    base = field(f)
    L = cam["L"]
    M = [(-S3 / 2 * L, L / 2), (S3 / 2 * L, L / 2), (0.0, -L)]
    zero = [math.atan2(-m[1], -m[0]) for m in M]       # direction of theta=0 in the robot frame
    err = cam.get("mount_yaw_error_deg", [0, 0, 0])
    W, H = cam["width"], cam["height"]
    cams = cfg.get("cameras", [1, 2, 3])
    frames, obs = [], []
    odometry = dead_reckoning([P[1:4] for P in cfg["poses"]], cfg["odometry"], seed_of(cfg["name"], "odometry")) if "odometry" in cfg else None
    for k, P in enumerate(cfg["poses"]):
        pt, x, y, hd = P[:4]
        others = f.get("robots", []) + (P[4] if len(P) > 4 else [])
        th = math.radians(hd)                 # angle of the robot x axis in the field frame
        rot = lambda p: (x + p[0] * math.cos(th) - p[1] * math.sin(th), y + p[0] * math.sin(th) + p[1] * math.cos(th))
        frames.append({"frame": k, "point": pt, "x_m": float(x), "y_m": float(y), "heading_deg": float(hd)})
        for i in cams:
            frames[-1]["M%d" % i] = "%s_%s_M%d.jpg" % (cfg["name"], pt, i)
        if odometry:
            frames[-1].update(zip(("odometry_x_m", "odometry_y_m", "odometry_heading_deg"), odometry[k]))
        for i in cams:
            mw = rot(M[i - 1])
            m = th + zero[i - 1] + math.radians(err[i - 1])
            right = (math.cos(m), math.sin(m), 0); down = (-math.sin(m), math.cos(m), 0)
            s = ""
            for j in (1, 2, 3):
                sj, zp = mirror_unit(cam, *rot(M[j - 1]), own=(j == i)); s += sj
            s += ("cylinder { %s %s 0.24 no_shadow pigment{rgb 0.05} finish{ambient 0.3 diffuse 0.4} }\n"
                  % (v3((x, y, 0.02)), v3((x, y, 0.45))))
            name = "%s_%s_M%d" % (cfg["name"], pt, i)
            cxy = cam["centers"][i - 1]
            pov = wallf(header() + pinhole((mw[0], mw[1], zp), (0, 0, 1), right, tuple(-q for q in down), W, H,
                                           cam["fx"], cam["fy"], cxy[0], cxy[1]) + base + robots(others) + s, amb, dif)
            png = os.path.join(out, name + "_clean.png")
            if not truth_only:
              render(pov, W, H, png, keep_pov=os.path.join(out, name + ".pov") if (k == 0 and i == cams[0]) else None)
              img = cv2.imread(png)
              if not clean:
                  os.remove(png)
              save(degrade(img, cfg["noise"], seed_of(cfg["name"], pt, i)), os.path.join(out, name + ".jpg"), cfg.get("quality", 93))
            for nm, q, rad in (("p", (-f["Fw"], f["Fd"]), f["pole_radius"]), ("q", (f["Fw"], f["Fd"]), f["pole_radius"]),
                               ("ball", f["ball"], f["ball_radius"])):
                dx, dy = q[0] - mw[0], q[1] - mw[1]
                d = math.hypot(dx, dy)
                thi = math.degrees(math.atan2(dy, dx) - th - zero[i - 1]) % 360.0
                blk = [j for j in (1, 2, 3) if j != i and circ_hit(mw, q, rot(M[j - 1]), cam["rim_radius"] * 1.1)]
                rb = any(circ_hit(mw, q, r[:2], r[2]) for r in others)
                # share of the object's height hidden by the own robot body (top disc r = 0.24 at z = 0.45)
                zt = 2 * rad if nm == "ball" else f["pole_height"]
                hid = 0
                for zz in np.linspace(0.02 * zt, 0.98 * zt, 25):
                    t = (cam["focus_height"] - 0.45) / (cam["focus_height"] - zz) if zz < cam["focus_height"] else 9.0
                    if t < 1 and math.hypot(mw[0] + t * dx - x, mw[1] + t * dy - y) < 0.24:
                        hid += 1
                obs.append({"hidden_by_body": hid / 25.0, "frame": k, "point": pt, "camera": i, "image": name + ".jpg", "object": nm,
                            "theta_deg": thi, "range_from_camera_m": d,
                            "half_width_deg": math.degrees(math.asin(rad / d)),
                            "blocked_by_own_mirror": int(bool(blk)), "blocked_by_robot": int(rb),
                            "covered": covered(mw, q, rad, others)})
            print(name, flush=True)
    for fr in frames:
        th = math.radians(fr["heading_deg"])
        for nm, q in (("p", (-f["Fw"], f["Fd"])), ("q", (f["Fw"], f["Fd"])), ("ball", f["ball"])):
            dx, dy = q[0] - fr["x_m"], q[1] - fr["y_m"]
            fr[nm + "_xr_m"] = dx * math.cos(th) + dy * math.sin(th)
            fr[nm + "_yr_m"] = -dx * math.sin(th) + dy * math.cos(th)
    write_csv(os.path.join(out, "frames.csv"), frames)
    write_csv(os.path.join(out, "observations.csv"), obs)
    cam = {k: v for k, v in cam.items() if k != "mount_yaw_error_deg"}
    json.dump({"scene": "B", "name": cfg["name"], "camera": cam, "field": {k: f[k] for k in ("Fw", "Fd", "pole_radius", "pole_height", "ball", "ball_radius")},
               "noise": cfg["noise"]}, open(os.path.join(out, "camera.json"), "w"), indent=1)


main()
