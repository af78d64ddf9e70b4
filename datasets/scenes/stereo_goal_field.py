#!/usr/bin/env python3
"""A football field of 1.5 x 1.3 m with yellow and blue goals, white walls and white lines on a dark floor, seen by the
narrow stereo camera of a 7.5 cm robot (paper 004), rendered with POV-Ray.

usage: stereo_goal_field.py CONFIG.json FOLDER [--clean | --truth-only] [--pov]
--clean keeps the images free of noise; --truth-only writes the tables and renders nothing; --pov keeps the first scene.
Field frame: origin at the field's corner on the blue goal line, x towards the yellow goal, y along the goal line, z up.
Robot frame: x forward, y left. A configuration with "odometry" adds columns with dead-reckoned poses to frames.csv.
"""
import sys
from scenelib import *


def goal_corners(f):
    X, Y, g = f["X"], f["Y"], f["goal_width"] / 2
    return {"blue_l": (0.0, Y / 2 - g), "blue_r": (0.0, Y / 2 + g), "yellow_l": (X, Y / 2 + g), "yellow_r": (X, Y / 2 - g)}


def line_points(f):
    """intersections of field markings: L = corner, T = junction with wall/goal line, X = crossing"""
    X, Y, yc = f["X"], f["Y"], f["Y"] / 2
    P = [("T_half_0", X / 2, 0.0), ("T_half_1", X / 2, Y),
         ("X_circle_0", X / 2, yc - f["circle_r"]), ("X_circle_1", X / 2, yc + f["circle_r"])]
    for side, x0, sx in (("blue", 0.0, 1), ("yellow", X, -1)):
        for nm, (w, d) in (("goal", f["goal_area"]), ("pen", f["penalty_area"])):
            for i, ys in enumerate((-1, 1)):
                P.append(("L_%s_%s_%d" % (side, nm, i), x0 + sx * d, yc + ys * w / 2))
                P.append(("T_%s_%s_%d" % (side, nm, i), x0, yc + ys * w / 2))
    return P


def field(f):
    X, Y, wh, wt = f["X"], f["Y"], f["wall_height"], f["wall_thickness"]
    gw, gd, lw = f["goal_width"] / 2, f["goal_depth"], f["line_width"]
    yc = Y / 2
    o = []
    fl = f["floor"]
    o.append("plane { <0,0,1>, -0.001 pigment { %s } finish{WALLF} }\n" % rgb(f.get("table", [0.3, 0.28, 0.26])))
    finish = "finish{WALLF}" if "gloss" not in f else (
        "finish{ambient %g diffuse %g reflection{%g}}" % (f.get("ambient", 0.35), f.get("diffuse", 0.6), f["gloss"]))
    o.append("box { <%g,%g,-0.0009> <%g,%g,0> pigment { granite scale 0.05 color_map { [0 %s] [1 %s] } } %s }\n"
             % (-gd, -wt, X + gd, Y + wt, rgb(fl), rgb([v * 1.4 for v in fl]), finish))
    white, top = "pigment{%s}" % rgb(f.get("wall_col", [0.88, 0.88, 0.88])), "pigment{rgb 0.04}"

    def wall(x0, y0, x1, y1, pig=white):
        o.append(box((x0, y0, 0), (x1, y1, wh - 0.001), pig))
        o.append(box((x0, y0, wh - 0.001), (x1, y1, wh), top))
    wall(-wt, -wt, X + wt, 0); wall(-wt, Y, X + wt, Y + wt)
    for sx, x0, col in ((-1, 0.0, f["blue"]), (1, X, f["yellow"])):
        cp = "pigment{%s}" % rgb(col)
        wall(x0, 0, x0 + sx * wt, yc - gw); wall(x0, yc + gw, x0 + sx * wt, Y)
        gh = f.get("goal_height", wh)
        side = cp if f.get("goal_sides", "coloured") == "coloured" else white
        e = 1e-4
        # inner faces of the goal: sides start exactly at the goal-line corner
        for ys in (-1, 1):
            ya = yc + ys * gw
            o.append(box((x0 + sx * e, ya, 0), (x0 + sx * (gd + wt), ya + ys * wt, gh), white))
            o.append(box((x0 + sx * e, ya - ys * 2e-4, 0), (x0 + sx * gd, ya, gh), side))
        o.append(box((x0 + sx * gd, yc - gw, 0), (x0 + sx * (gd + wt), yc + gw, gh), cp))

    def line(x0, y0, x1, y1):
        o.append(box((x0, y0, -0.0005), (x1, y1, 2e-4), "pigment{rgb 0.9}"))
    line(X / 2 - lw / 2, 0, X / 2 + lw / 2, Y)
    cr = f["circle_r"]
    o.append("difference { cylinder { <%g,%g,-0.0005> <%g,%g,2e-4> %g } cylinder { <%g,%g,-0.001> <%g,%g,3e-4> %g } pigment{rgb 0.9} finish{WALLF} }\n"
             % (X / 2, yc, X / 2, yc, cr + lw / 2, X / 2, yc, X / 2, yc, cr - lw / 2))
    for sx, x0 in ((1, 0.0), (-1, X)):
        for (w, d) in (f["goal_area"], f["penalty_area"]):
            line(x0 + sx * d - lw / 2, yc - w / 2, x0 + sx * d + lw / 2, yc + w / 2)
            for ys in (-1, 1):
                line(min(x0, x0 + sx * d), yc + ys * w / 2 - lw / 2, max(x0, x0 + sx * d), yc + ys * w / 2 + lw / 2)
        line(min(x0, x0 + sx * lw), yc - gw, max(x0, x0 + sx * lw), yc + gw)
    for b in f.get("background", []):
        o.append(box(b["lo"], b["hi"], "pigment{ granite scale 0.4 color_map{[0 %s][1 %s]} }" % (rgb(b["col"]), rgb([v * 0.6 for v in b["col"]]))))
    for l in f["lights"]:
        o.append(light(l["pos"], l.get("power", 1), l.get("col", [1, 1, 1]), l.get("fade"), l.get("soft", 0)))
    return "".join(o)


def robot_box(r, s=0.075):
    """occluding robot: cube of side s at (x,y,heading deg), drawn as a mesh-free prism"""
    x, y, hd = r[:3]; col = r[3] if len(r) > 3 else [0.08, 0.08, 0.09]
    c, n = math.cos(math.radians(hd)), math.sin(math.radians(hd))
    P = [(x + a * c - b * n, y + a * n + b * c) for a, b in ((s / 2, s / 2), (-s / 2, s / 2), (-s / 2, -s / 2), (s / 2, -s / 2))]
    # prism sweeps along y in POV: build it from two triangles per face
    o = "mesh {\n"
    q = [(p[0], p[1], 0.003) for p in P] + [(p[0], p[1], s) for p in P]
    F = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)]
    for a in F:
        o += "triangle{%s %s %s} triangle{%s %s %s}\n" % tuple(v3(q[i]) for i in (a[0], a[1], a[2], a[0], a[2], a[3]))
    o += "pigment{%s} finish{WALLF} }\n" % rgb(col)
    edges = [(P[i], P[(i + 1) % 4]) for i in range(4)]
    return o, edges


MAP_IDS = {"blue_l": 1, "blue_r": 2, "yellow_r": 3, "yellow_l": 4}
FIRST_LINE_ID = 11


def field_map(f):
    """goal corners, known by their ids, and line points, known by their kind only"""
    rows = [{"id": MAP_IDS[n], "name": n, "x_m": p[0], "y_m": p[1], "category": ""} for n, p in goal_corners(f).items()]
    for i, (n, x, y) in enumerate(line_points(f)):
        rows.append({"id": FIRST_LINE_ID + i, "name": n, "x_m": float(x), "y_m": float(y), "category": n[0]})
    return sorted(rows, key=lambda r: r["id"])


def main():
    cfg = json.load(open(sys.argv[1])); out = sys.argv[2]; clean = "--clean" in sys.argv; truth_only = "--truth-only" in sys.argv
    os.makedirs(out, exist_ok=True)
    f, st = cfg["field"], cfg["stereo"]
    amb, dif = f.get("ambient", 0.35), f.get("diffuse", 0.6)
    base = field(f)
    G = goal_corners(f)
    fmt = cfg.get("format", "jpg")
    frames, obs, lobs = [], [], []
    odometry = dead_reckoning([P["pose"] for P in cfg["poses"]], cfg["odometry"], seed_of(cfg["name"], "odometry")) if "odometry" in cfg else None
    W, H = st["width"], st["height"]
    fx = (W / 2) / math.tan(math.radians(st["hfov_deg"] / 2))
    cx, cy = (W - 1) / 2 + st.get("dcx", 0.0) * W / 320, (H - 1) / 2 + st.get("dcy", 0.0) * W / 320
    b, fo, h = st["baseline"], st["forward"], st["height_m"]
    pit = math.radians(st.get("pitch_deg", 0.0))         # positive = looking down
    # side walls of the goals that hide the coloured back wall (plan view)
    X, Y = f["X"], f["Y"]
    wl = [((0, 0), G["blue_l"]), (G["blue_r"], (0, Y)), ((X, 0), G["yellow_r"]), (G["yellow_l"], (X, Y))]
    for k, P in enumerate(cfg["poses"]):
        x, y, hd = P["pose"]
        th = math.radians(hd); c, s = math.cos(th), math.sin(th)
        body, edges = "", []
        for r in P.get("robots", []):
            t, e = robot_box(r); body += t; edges += e
        name = "%s_%02d" % (cfg["name"], k)
        fwd = (c * math.cos(pit), s * math.cos(pit), -math.sin(pit))
        up = (c * math.sin(pit), s * math.sin(pit), math.cos(pit))
        right = (s, -c, 0)
        fr = {"frame": k, "left": name + "_L." + fmt, "right": name + "_R." + fmt, "x_m": float(x), "y_m": float(y), "heading_deg": float(hd), "robots": len(P.get("robots", []))}
        if odometry:
            fr.update(zip(("odometry_x_m", "odometry_y_m", "odometry_heading_deg"), odometry[k]))
        frames.append(fr)
        eye = {}
        for side, sg in (("L", 1), ("R", -1)):
            ex, ey = x + fo * c - sg * b / 2 * s, y + fo * s + sg * b / 2 * c
            eye[side] = (ex, ey)
            pov = wallf(header() + pinhole((ex, ey, h), fwd, right, up, W, H, fx, fx, cx, cy) + base + body, amb, dif)
            if truth_only:
                continue
            png = os.path.join(out, "%s_%s_clean.png" % (name, side))
            render(pov, W, H, png, keep_pov=os.path.join(out, name + ".pov") if (k == 0 and side == "L" and "--pov" in sys.argv) else None,
                   ss=cfg.get("supersample", 4))
            img = cv2.imread(png)
            if not clean:
                os.remove(png)
            save(degrade(img, cfg["noise"], seed_of(cfg["name"], k, side)), os.path.join(out, fr["left" if side == "L" else "right"]), cfg.get("quality", 95))

        def proj(e, p, z):
            d = np.array([p[0] - e[0], p[1] - e[1], z - h])
            zc = float(np.dot(d, fwd))
            if zc < 0.02:
                return None
            return cx + fx * float(np.dot(d, right)) / zc, cy - fx * float(np.dot(d, up)) / zc, zc
        for nm, p in G.items():
            vis = {}
            row = {"frame": k, "landmark": nm, "lx_m": float(p[0]), "ly_m": float(p[1])}
            ok = True
            for side in "LR":
                bot, topp = proj(eye[side], p, 0.0), proj(eye[side], p, f["wall_height"])
                inside = bot is not None and 0 <= bot[0] <= W - 1
                occ = any(seg_hit(eye[side], p, a, q) for a, q in edges)
                # in front of the goal line plane; looking at the goal from inside the field always true here
                row["u" + side] = float(bot[0]) if bot else float("nan")
                row["vbot" + side] = float(bot[1]) if bot else float("nan")
                row["vtop" + side] = float(topp[1]) if topp else float("nan")
                row["in_view" + side] = int(inside); row["occluded" + side] = int(occ)
                ok = ok and inside and not occ
            dxr = (p[0] - x) * c + (p[1] - y) * s; dyr = -(p[0] - x) * s + (p[1] - y) * c
            row["xr_m"], row["yr_m"] = dxr, dyr
            row["range_robot_m"] = math.hypot(dxr, dyr)
            row["bearing_robot_deg"] = math.degrees(math.atan2(dyr, dxr))
            row["range_left_m"] = math.hypot(p[0] - eye["L"][0], p[1] - eye["L"][1])
            row["depth_left_m"] = (p[0] - eye["L"][0]) * c + (p[1] - eye["L"][1]) * s
            row["visible_both"] = int(ok)
            obs.append(row)
        for nm, px, py in line_points(f):
            r = {"frame": k, "point": nm, "fx_m": float(px), "fy_m": float(py)}
            ok = True
            for side in "LR":
                q = proj(eye[side], (px, py), 0.0)
                ins = q is not None and 0 <= q[0] <= W - 1 and 0 <= q[1] <= H - 1
                occ = any(seg_hit(eye[side], (px, py), a, e) for a, e in edges)
                r["u" + side], r["v" + side] = (float(q[0]), float(q[1])) if q else (float("nan"), float("nan"))
                ok = ok and ins and not occ
            if r["uL"] == r["uL"]:
                r["visible_both"] = int(ok)
                lobs.append(r)
        print(name, flush=True)
    write_csv(os.path.join(out, "line_points.csv"), lobs)
    write_csv(os.path.join(out, "frames.csv"), frames)
    write_csv(os.path.join(out, "observations.csv"), obs)
    write_csv(os.path.join(out, "map.csv"), field_map(f))
    json.dump({"scene": "C", "name": cfg["name"], "stereo": dict(st, fx=fx, fy=fx, cx=cx, cy=cy), "noise": cfg["noise"],
               "field": {k: f[k] for k in ("X", "Y", "wall_height", "goal_width", "goal_depth", "line_width", "circle_r", "goal_area", "penalty_area")},
               "goal_sides": f.get("goal_sides", "coloured"),
               "goal_corners": G, "robots": [{"frame": i, "robots": P["robots"]} for i, P in enumerate(cfg["poses"]) if P.get("robots")]},
              open(os.path.join(out, "camera.json"), "w"), indent=1)


main()
