"""Common parts of the scene generators; they need povray, python3-numpy and python3-opencv.

All world coordinates are right-handed, metres, z up.  POV-Ray's own handedness never
matters here because every point is written out explicitly and the camera is given as the
explicit triple (direction, right, up): the ray of pixel (i, j) is
    direction + ((i + 0.5)/W - 0.5) * right + (0.5 - (j + 0.5)/H) * up
"""
import csv, json, math, os, subprocess, zlib
import numpy as np
import cv2


def v3(p):
    return "<%.9g,%.9g,%.9g>" % (p[0], p[1], p[2])


def rgb(c):
    return "rgb <%.4g,%.4g,%.4g>" % tuple(c)


def pinhole(loc, fwd, right, up, W, H, fx, fy, cx, cy):
    """Explicit POV camera for a pinhole with OpenCV intrinsics (pixel centres at integers)."""
    fwd, right, up = (np.asarray(a, float) for a in (fwd, right, up))
    d = fwd + ((W - 1) / 2 - cx) / fx * right + (cy - (H - 1) / 2) / fy * up
    return ("camera { perspective location %s\n direction %s\n right %s\n up %s }\n"
            % (v3(loc), v3(d), v3(right * W / fx), v3(up * H / fy)))


def box(a, b, pig, fin="finish{WALLF}"):
    lo = np.minimum(a, b)
    hi = np.maximum(a, b)
    return "box { %s %s %s %s }\n" % (v3(lo), v3(hi), pig, fin)


def header(ambient=0.30, diffuse=0.65):
    return ("#version 3.7;\nglobal_settings { assumed_gamma 1.0 max_trace_level 8 }\n"
            "background { rgb <0.02,0.02,0.02> }\n"
            "#macro NONE() #end\n"
            "#declare AMB=%g; #declare DIF=%g;\n" % (ambient, diffuse)).replace("#macro NONE() #end\n", "")


def wallf(txt, ambient, diffuse):
    return txt.replace("finish{WALLF}", "finish{ambient %g diffuse %g}" % (ambient, diffuse))


def light(pos, power=1.0, col=(1, 1, 1), fade=None, soft=0.0):
    s = "light_source { %s rgb <%.4g,%.4g,%.4g>" % (v3(pos), col[0] * power, col[1] * power, col[2] * power)
    if fade:
        s += " fade_distance %g fade_power 2" % fade
    if soft > 0:
        s += " area_light <%g,0,0>,<0,%g,0>,4,4 adaptive 1 jitter" % (soft, soft)
    return s + " }\n"


def srgb_to_linear(v):
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def linear_to_srgb(v):
    return np.where(v <= 0.0031308, v * 12.92, 1.055 * np.power(np.maximum(v, 0), 1 / 2.4) - 0.055)


def render(pov_text, W, H, out_png, aa=0.08, keep_pov=None, ss=1):
    """ss > 1 or (columns, rows): brute-force supersampling (so many rays per pixel, box-averaged in linear light).
    POV-Ray's adaptive anti-aliasing misses structures thinner than a pixel, ss does not. An upright edge is then up to
    half a ray beside its place."""
    sx, sy = ss if isinstance(ss, (tuple, list)) else (ss, ss)
    base = out_png[:-4]
    pov = keep_pov or base + ".pov"
    with open(pov, "w") as f:
        f.write(pov_text)
    cmd = ["povray", "+I" + pov, "+O" + out_png, "+W%d" % (W * sx), "+H%d" % (H * sy), "-D", "-GA", "+FN8", "+WT1"]
    cmd += ["-A"] if sx * sy > 1 else ["+A%g" % aa, "+AM1", "+R4", "-J"]
    r = subprocess.run(cmd, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if r.returncode != 0 or not os.path.exists(out_png):
        raise RuntimeError("povray failed: " + r.stderr[-2000:])
    if sx * sy > 1:
        im = srgb_to_linear(cv2.imread(out_png).astype(np.float32) / 255)
        im = im.reshape(H, sy, W, sx, 3).mean(axis=(1, 3))
        cv2.imwrite(out_png, np.rint(linear_to_srgb(im) * 255).astype(np.uint8))
    if not keep_pov:
        os.remove(pov)


def degrade(img, cfg, seed):
    """Camera effects, applied to the noise-free 8-bit render.
    cfg keys: blur (sigma px), gain, read (grey levels), shot (levels at 255), vignette (0..1),
    cast ([b,g,r] multipliers), k1 (not applied when 0)."""
    rng = np.random.default_rng(seed)
    f = img.astype(np.float32)
    if cfg.get("blur", 0) > 0:
        f = cv2.GaussianBlur(f, (0, 0), cfg["blur"])
    h, w = f.shape[:2]
    if cfg.get("vignette", 0) > 0:
        yy, xx = np.mgrid[0:h, 0:w]
        r2 = ((xx - w / 2) ** 2 + (yy - h / 2) ** 2) / ((w / 2) ** 2 + (h / 2) ** 2)
        f *= (1 - cfg["vignette"] * r2)[..., None]
    f *= cfg.get("gain", 1.0)
    f *= np.array(cfg.get("cast", [1, 1, 1]), np.float32)
    sig = np.sqrt(cfg.get("read", 0.0) ** 2 + cfg.get("shot", 0.0) ** 2 * np.clip(f, 0, 255) / 255.0)
    f += rng.standard_normal(f.shape).astype(np.float32) * sig
    return np.clip(np.rint(f), 0, 255).astype(np.uint8)


def save(img, path, quality=93, subsampling=0):
    if path.endswith(".jpg"):
        from PIL import Image
        Image.fromarray(img[:, :, ::-1]).save(path, quality=quality, subsampling=subsampling)
    else:
        cv2.imwrite(path, img, [cv2.IMWRITE_PNG_COMPRESSION, 9])


def seed_of(*a):
    return zlib.crc32(repr(a).encode())


def write_csv(path, rows):
    if not rows:
        return
    keys = list(rows[0].keys())
    with open(path, "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(keys)
        for r in rows:
            w.writerow([("%.6g" % r[k]) if isinstance(r[k], float) else r[k] for k in keys])


def wrap(a):
    return math.atan2(math.sin(a), math.cos(a))


def wrapdeg(a):
    return (a + 180.0) % 360.0 - 180.0


def dead_reckoning(poses, noise, seed):
    """poses as odometry tells them: starts at zero, every step in robot axes with Gaussian errors"""
    rng = np.random.default_rng(seed)
    out = [(0.0, 0.0, 0.0)]
    for (x0, y0, h0), (x1, y1, h1) in zip(poses, poses[1:]):
        a = math.radians(h0)
        dx, dy, dh = x1 - x0, y1 - y0, wrapdeg(h1 - h0)
        way = math.hypot(dx, dy)
        fx = dx * math.cos(a) + dy * math.sin(a) + noise["xy_per_m"] * math.sqrt(way) * rng.standard_normal()
        fy = -dx * math.sin(a) + dy * math.cos(a) + noise["xy_per_m"] * math.sqrt(way) * rng.standard_normal()
        dh += noise["deg_per_m"] * math.sqrt(way) * rng.standard_normal()
        x, y, h = out[-1]
        b = math.radians(h)
        out.append((x + fx * math.cos(b) - fy * math.sin(b), y + fx * math.sin(b) + fy * math.cos(b), wrapdeg(h + dh)))
    return out


# ---------------------------------------------------------------- plan-view visibility
def seg_hit(p, q, a, b, eps=1e-6):
    """True if the open segment p->q crosses segment a-b (touching near q does not count)."""
    p, q, a, b = (np.asarray(t, float) for t in (p, q, a, b))
    r, s = q - p, b - a
    den = r[0] * s[1] - r[1] * s[0]
    if abs(den) < 1e-12:
        return False
    t = ((a - p)[0] * s[1] - (a - p)[1] * s[0]) / den
    u = ((a - p)[0] * r[1] - (a - p)[1] * r[0]) / den
    L = np.hypot(*r)
    return 1e-6 < t < 1 - 1e-4 / max(L, 1e-9) and -1e-9 <= u <= 1 + 1e-9


def circ_hit(p, q, c, rad):
    p, q, c = (np.asarray(t, float) for t in (p, q, c))
    d = q - p
    t = np.clip(np.dot(c - p, d) / np.dot(d, d), 0, 1)
    return np.hypot(*(p + t * d - c)) < rad


def rect_edges(x0, y0, x1, y1):
    P = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    return [(P[i], P[(i + 1) % 4]) for i in range(4)]
