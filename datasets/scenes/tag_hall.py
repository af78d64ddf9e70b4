#!/usr/bin/env python3
"""A hall with fiducial tags (AprilTag or ArUco) on its walls, seen by one camera of a robot: every pixel is the mean of
rays in linear light, through a lens with distortion.

usage: tag_hall.py CONFIG.json FOLDER [--clean | --truth-only]
--clean keeps the images free of noise; --truth-only writes the tables and draws nothing.
Map frame: origin in a corner of the hall, z up. Robot frame: x forward, y left. `corner_noise_px` moves every corner of a
tag in the image before it is drawn, independently: what a tag that is not flat, a rolling shutter or a poor calibration do.
"""
import sys
from scenelib import *

EDGE = [(-1, 1), (1, 1), (1, -1), (-1, -1)]    # corners of a tag's black border, x to its right, y up
SAMPLES = 3                                    # rays per pixel along each axis


def camera_of(c):
    W, H = c["width"], c["height"]
    f = (W / 2) / math.tan(math.radians(c["hfov_deg"] / 2))
    return dict({"fx": f, "fy": f, "cx": (W - 1) / 2, "cy": (H - 1) / 2, "k1": 0.0, "k2": 0.0, "p1": 0.0, "p2": 0.0, "k3": 0.0,
                 "forward": 0.0, "left": 0.0, "mount_yaw_deg": 0.0, "pitch_deg": 0.0, "roll_deg": 0.0}, **c)


def lens(c):
    return np.array([[c["fx"], 0, c["cx"]], [0, c["fy"], c["cy"]], [0, 0, 1.0]]), np.array([c[k] for k in ("k1", "k2", "p1", "p2", "k3")])


def rays_of(c, pixels):
    """undistorted (x/z, y/z) of pixels"""
    K, d = lens(c)
    points = np.ascontiguousarray(pixels, np.float64).reshape(-1, 1, 2)
    return cv2.undistortPointsIter(points, K, d, None, None, (3, 40, 1e-9)).reshape(-1, 2)


def axes_of(c, pose):
    """camera centre and its axes (right, down, forward) in the map frame"""
    x, y, hd = pose
    a = math.radians(hd)
    centre = np.array([x + c["forward"] * math.cos(a) - c["left"] * math.sin(a), y + c["forward"] * math.sin(a) + c["left"] * math.cos(a), c["height_m"]])
    a += math.radians(c["mount_yaw_deg"])
    p, r = math.radians(c["pitch_deg"]), math.radians(c["roll_deg"])
    fwd = np.array([math.cos(a) * math.cos(p), math.sin(a) * math.cos(p), -math.sin(p)])
    right = np.array([math.sin(a), -math.cos(a), 0])
    down = np.cross(fwd, right)
    return centre, np.stack([math.cos(r) * right + math.sin(r) * down, -math.sin(r) * right + math.cos(r) * down, fwd])


def corners_of(tag, edge):
    """of the black border, in the map frame; the tag hangs upright and faces `facing_deg`"""
    a = math.radians(tag["facing_deg"])
    right = np.array([-math.sin(a), math.cos(a), 0])     # as one sees it who stands before it
    return [np.array(tag["at"]) + edge / 2 * (x * right + y * np.array([0, 0, 1.0])) for x, y in EDGE]


def pattern_of(dictionary, number):
    """cells of a tag with its border, 1 is white, and a white margin of one cell"""
    known = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, "DICT_" + dictionary))
    draw_marker = getattr(cv2.aruco, "generateImageMarker", None) or cv2.aruco.drawMarker   # OpenCV 4.7 has renamed it
    cells = (draw_marker(known, number, known.markerSize + 2) > 127).astype(float)
    return np.pad(cells, 1, constant_values=1.0)


class Hall:
    def __init__(self, h, seed):
        self.size, self.rng = np.array(h["size"]), np.random.default_rng(seed)
        self.ambient, self.lamps = h.get("ambient", 0.4), h["lamps"]
        # pictures on the walls: rectangles of one brightness, (wall, from, to, low, high, brightness)
        self.pictures = [(int(self.rng.integers(4)), a, a + self.rng.uniform(0.2, 1.2), z, z + self.rng.uniform(0.1, 0.9), self.rng.uniform(0.05, 0.9))
                         for a, z in zip(self.rng.uniform(0, max(self.size), h.get("pictures", 0)), self.rng.uniform(0, self.size[2], h.get("pictures", 0)))]

    def seen(self, centre, rays):
        """reflected light and position of what the rays meet"""
        with np.errstate(divide="ignore", invalid="ignore"):
            t = np.where(rays > 0, (self.size - centre) / rays, np.where(rays < 0, -centre / rays, np.inf))
        side = np.argmin(t, axis=1)
        at = centre + rays * np.take_along_axis(t, side[:, None], 1)
        wall = np.where(side == 0, np.where(rays[:, 0] > 0, 0, 2), np.where(rays[:, 1] > 0, 1, 3))
        paint = np.where(side == 2, np.where(rays[:, 2] > 0, 0.75, 0.18 + 0.12 * ((np.floor(at[:, 0] * 2) + np.floor(at[:, 1] * 2)) % 2)), 0.55)
        along = np.where(side == 0, at[:, 1], at[:, 0])
        for w, a, b, low, high, brightness in self.pictures:
            paint[(side < 2) & (wall == w) & (along > a) & (along < b) & (at[:, 2] > low) & (at[:, 2] < high)] = brightness
        return paint, at

    def light(self, at):
        return self.ambient + sum(l["power"] / (0.3 + np.sum((at - np.array(l["at"])) ** 2, axis=1)) for l in self.lamps)


def samples_of(c):
    """positions in pixels and rays of all samples of an image"""
    v, u = np.mgrid[0:c["height"] * SAMPLES, 0:c["width"] * SAMPLES]
    pixels = np.stack([(u.ravel() + 0.5) / SAMPLES - 0.5, (v.ravel() + 0.5) / SAMPLES - 0.5], axis=1)
    return pixels.astype(np.float32), rays_of(c, pixels).astype(np.float32)


def draw(c, samples, hall, pose, seen_tags, patterns, blur):
    """linear light per pixel; seen_tags: (id, corners in pixels)"""
    pixels, flat = samples
    centre, axes = axes_of(c, pose)
    paint, at = hall.seen(centre, np.column_stack([flat, np.ones(len(flat), np.float32)]) @ axes.astype(np.float32))
    for number, corners in seen_tags:
        cells = patterns[number]
        n_cells = len(cells)
        half = n_cells / (n_cells - 2)                   # of the tag with its margin, its border is from -1 to 1
        warp = cv2.getPerspectiveTransform(rays_of(c, corners).astype(np.float32), np.array(EDGE, np.float32))
        low, high = corners.min(axis=0) - 0.5 * np.ptp(corners, axis=0) - 4, corners.max(axis=0) + 0.5 * np.ptp(corners, axis=0) + 4
        near = np.flatnonzero(np.all((pixels > low) & (pixels < high), axis=1))
        if len(near) == 0:
            continue
        on = cv2.perspectiveTransform(flat[near].reshape(-1, 1, 2), warp.astype(float)).reshape(-1, 2)
        hit = np.all(np.abs(on) < half, axis=1)
        col = np.clip(((on[hit, 0] + half) / (2 * half) * n_cells).astype(int), 0, n_cells - 1)
        row = np.clip(((half - on[hit, 1]) / (2 * half) * n_cells).astype(int), 0, n_cells - 1)
        paint[near[hit]] = 0.04 + 0.8 * cells[row, col]
    image = (paint * hall.light(at)).reshape(c["height"], SAMPLES, c["width"], SAMPLES).mean(axis=(1, 3))
    return cv2.GaussianBlur(image, (0, 0), blur) if blur > 0 else image


def view_of(c, pose, tag, edge):
    """true corners [px], horizontal range [m], bearing from the camera's forward axis [deg] and how obliquely it is seen;
    nothing when a corner is behind the camera"""
    centre, axes = axes_of(c, pose)
    points = (np.array(corners_of(tag, edge)) - centre) @ axes.T
    if points[:, 2].min() < 0.1 or np.abs(points[:, 0] / points[:, 2]).max() > 1.2:
        return None
    K, d = lens(c)
    pixels = cv2.projectPoints(points.reshape(-1, 1, 3), np.zeros(3), np.zeros(3), K, d)[0].reshape(-1, 2)
    way = np.array(tag["at"]) - centre
    a, f = math.radians(pose[2] + c["mount_yaw_deg"]), math.radians(tag["facing_deg"])
    facing = -(way[0] * math.cos(f) + way[1] * math.sin(f)) / math.hypot(*way[:2])
    return {"pixels": pixels, "range": math.hypot(*way[:2]), "bearing": wrapdeg(math.degrees(math.atan2(way[1], way[0]) - a)),
            "oblique": math.degrees(math.acos(max(-1, min(1, facing)))), "facing": facing}


def main():
    cfg = json.load(open(sys.argv[1])); out = sys.argv[2]; clean = "--clean" in sys.argv; truth_only = "--truth-only" in sys.argv
    os.makedirs(out, exist_ok=True)
    c, edge, tags = camera_of(cfg["camera"]), cfg["tag_edge_m"], cfg["tags"]
    hall = Hall(cfg["hall"], seed_of(cfg["name"], "hall"))
    patterns = {t["id"]: pattern_of(cfg["dictionary"], t["id"]) for t in tags}
    samples = None if truth_only else samples_of(c)
    noise, jitter = cfg["noise"], cfg.get("corner_noise_px", 0.0)
    odometry = dead_reckoning(cfg["poses"], cfg["odometry"], seed_of(cfg["name"], "odometry"))
    frames, observations = [], []
    for k, pose in enumerate(cfg["poses"]):
        rng = np.random.default_rng(seed_of(cfg["name"], k))
        image = "%s_%02d.%s" % (cfg["name"], k, cfg.get("format", "jpg"))
        frames.append(dict(zip(("frame", "t", "image", "x_m", "y_m", "heading_deg", "odometry_x_m", "odometry_y_m", "odometry_heading_deg"),
                               [k, round(k * cfg.get("seconds_per_frame", 1), 6), image] + [float(p) for p in pose] + list(odometry[k]))))
        drawn = []
        for tag in tags:
            view = view_of(c, pose, tag, edge)
            if not view or view["facing"] <= 0:
                continue
            corners = view["pixels"] + jitter * rng.standard_normal((4, 2))
            drawn.append((view["range"], tag["id"], corners))
            low, high = view["pixels"].min(axis=0), view["pixels"].max(axis=0)
            inside = low.min() > 8 and high[0] < c["width"] - 9 and high[1] < c["height"] - 9
            observations.append(dict({"frame": k, "id": tag["id"], "range_m": view["range"], "bearing_deg": view["bearing"], "oblique_deg": view["oblique"],
                                      "edge_px": math.sqrt(abs(cv2.contourArea(view["pixels"].astype(np.float32)))), "in_view": int(inside)},
                                     **{axis + str(i): float(view["pixels"][i, j]) for i in range(4) for j, axis in enumerate("uv")}))
        if truth_only:
            continue
        drawn.sort(key=lambda d: -d[0])                  # nearer tags over farther ones
        light = draw(c, samples, hall, pose, [d[1:] for d in drawn], patterns, noise.get("blur", 0))
        grey = np.rint(255 * linear_to_srgb(np.clip(light * noise.get("exposure", 1), 0, 1))).astype(np.uint8)
        if not clean:
            grey = degrade(grey[..., None], dict(noise, blur=0, cast=[1]), seed_of(cfg["name"], k, "noise"))[..., 0]
        if image.endswith(".jpg"):
            cv2.imwrite(os.path.join(out, image), grey, [cv2.IMWRITE_JPEG_QUALITY, cfg.get("quality", 90)])
        else:
            cv2.imwrite(os.path.join(out, image), grey)
        print(image, flush=True)
    write_csv(os.path.join(out, "frames.csv"), frames)
    write_csv(os.path.join(out, "observations.csv"), observations)
    write_csv(os.path.join(out, "map.csv"), [{"id": t["id"], "name": "tag%d" % t["id"], "x_m": float(t["at"][0]), "y_m": float(t["at"][1]),
                                               "yaw_deg": float(t["facing_deg"])} for t in tags])
    json.dump({"scene": "tags", "name": cfg["name"], "dictionary": cfg["dictionary"], "camera": dict(c, tag_edge_m=edge), "noise": noise},
              open(os.path.join(out, "camera.json"), "w"), indent=1)


if __name__ == "__main__":
    main()
