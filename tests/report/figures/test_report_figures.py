"""Computes the numbers of a report again from the trajectories beside it, and compares.

    test_report_figures.py RUN_FOLDER TRUTH.tum

Shares no code with the program: TUM files, steps.csv and the truth go in, the tables and curves of report.html and
summary.json must come out. For a run with dense truth over a log that is no longer than its playback."""

import csv
import html
import json
import math
import pathlib
import random
import re
import sys
import unittest

HOLD = 5  # [s] that a method must stay within the limits to have converged
MAX_GAP = 0.5  # [s] of the truth
ROUNDED = 6e-4  # half of the last digit of three decimals, and a little


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


def read_tum(path):
    rows = []
    for line in pathlib.Path(path).read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        t, x, y, _, qx, qy, qz, qw = (float(field) for field in line.split())
        known = any((qx, qy, qz, qw))
        rows.append((t, x, y, 2 * math.atan2(qz, qw) if known else None))
    return rows


def interpolate(rows, time, gap):
    """(x, y, heading) between two rows at most `gap` apart; None elsewhere."""
    low, high = 0, len(rows)
    while low < high:
        middle = (low + high) // 2
        low, high = (middle + 1, high) if rows[middle][0] <= time else (low, middle)
    if low == 0:
        return None
    before = rows[low - 1]
    if before[0] == time:
        return before[1:]
    if low == len(rows) or rows[low][0] - before[0] > gap:
        return None
    after = rows[low]
    share = (time - before[0]) / (after[0] - before[0])
    heading = before[3] + share * wrap(after[3] - before[3])
    return before[1] + share * (after[1] - before[1]), before[2] + share * (after[2] - before[2]), wrap(heading)


def quantile(values, probability):
    ordered = sorted(values)
    place = probability * (len(ordered) - 1)
    low = math.floor(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (place - low) * (ordered[high] - ordered[low])


def root_mean_square(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def block_interval(values, block=10, resamples=2000):
    generator = random.Random(3)
    found = []
    for _ in range(resamples):
        drawn = []
        for _ in range(0, len(values), block):
            first = generator.randrange(len(values) - block + 1)
            drawn += values[first:first + block]
        found.append(root_mean_square(drawn))
    return quantile(found, 0.025), quantile(found, 0.975)


def normalised_square(upper, e):
    """e^T P^-1 e by Gaussian elimination; `upper`: upper triangle of P, row by row."""
    a, b, c, d, f, g = upper
    rows = [[a, b, c, e[0]], [b, d, f, e[1]], [c, f, g, e[2]]]
    for k in range(3):
        for r in range(k + 1, 3):
            factor = rows[r][k] / rows[k][k]
            rows[r] = [below - factor * above for below, above in zip(rows[r], rows[k])]
    solution = [0.0, 0.0, 0.0]
    for k in (2, 1, 0):
        rest = sum(rows[k][c] * solution[c] for c in range(k + 1, 3))
        solution[k] = (rows[k][3] - rest) / rows[k][k]
    return sum(error * part for error, part in zip(e, solution))


class Run:
    """The output of a run, and the errors computed from it."""

    def __init__(self, folder, truth):
        self.summary = json.loads((folder / "summary.json").read_text())
        self.page = (folder / "report.html").read_text()
        self.data = json.loads(re.search(r'id="run-data">(.*?)</script>', self.page, re.S).group(1))
        self.truth = read_tum(truth)
        self.trajectories = {name: read_tum(folder / f"trajectory_{name}.tum") for name in self.summary["methods"]}
        with open(folder / "steps.csv", newline="") as file:
            self.steps = list(csv.DictReader(file))
        ini = (folder / "config_resolved.ini").read_text()
        self.within_m, self.within_deg = (
            float(re.search(rf"^{key}\s*=\s*([\d.]+)", ini, re.M).group(1))
            for key in ("converged_within_m", "converged_within_deg"))
        frames = [float(step["t"]) for step in self.steps]
        self.start = frames[0] - self.data["playback"]["t"][0]
        end = self.start + self.summary["rawlog"]["duration_s"]
        self.stamps = [stamp for stamp in range(math.ceil(self.start), math.floor(end) + 1)
                       if interpolate(self.truth, stamp, MAX_GAP)]
        self.continuous = {m["name"] for m in self.data["methods"] if m["continuous"]}
        self.errors = {name: self.errors_of(name) for name in self.trajectories}
        self.from_stamp = self.convergence()

    def estimate_for(self, name, stamp):
        """(time, pose): predicted to the stamp by dead reckoning, or at its own time for a closed form."""
        last = None
        for row in self.trajectories[name]:
            if row[0] > stamp:
                break
            last = row
        if last is None:
            return None
        if name not in self.continuous:
            return (last[0], last[1:]) if last[0] > stamp - 1 else None
        odometry = self.trajectories["odometry"]
        before, after = interpolate(odometry, last[0], 1e9), interpolate(odometry, stamp, 1e9) or odometry[-1][1:]
        dx, dy = after[0] - before[0], after[1] - before[1]
        turned = last[3] - before[2]
        x = last[1] + math.cos(turned) * dx - math.sin(turned) * dy
        y = last[2] + math.sin(turned) * dx + math.cos(turned) * dy
        return stamp, (x, y, wrap(last[3] + after[2] - before[2]))

    def errors_of(self, name):
        """{stamp: (time, position error, heading error)}"""
        errors = {}
        for stamp in self.stamps:
            estimate = self.estimate_for(name, stamp)
            truth = interpolate(self.truth, estimate[0], MAX_GAP) if estimate else None
            if truth:
                pose = estimate[1]
                heading = None if pose[2] is None else abs(math.degrees(wrap(pose[2] - truth[2])))
                errors[stamp] = estimate[0], math.hypot(pose[0] - truth[0], pose[1] - truth[1]), heading
        return errors

    def convergence(self):
        begin = None
        for stamp, (_, position, heading) in self.errors["particle_filter"].items():
            if position > self.within_m or heading > self.within_deg:
                begin = None
                continue
            begin = stamp if begin is None else begin
            if stamp - begin >= HOLD:
                return begin
        return None

    def counted(self, name, what=1):
        return [error[what] for stamp, error in self.errors[name].items() if stamp >= self.from_stamp]

    def table(self, css_class):
        """Rows of cells of the tables of this class, one list per table."""
        tables = []
        for text in re.findall(rf'<table class="{css_class}">(.*?)</table>', self.page, re.S):
            rows = []
            for row in re.findall(r"<tr[^>]*>(.*?)</tr>", text, re.S):
                cells = re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.S)
                cells = [re.sub(r'<span class="badge[^>]*>.*?</span>', "", cell) for cell in cells]
                rows.append([html.unescape(re.sub(r"<[^>]+>", " ", cell.replace("<wbr/>", ""))).strip()
                             for cell in cells])
            tables.append(rows)
        return tables


class Figures(unittest.TestCase):
    run_folder = truth = None

    @classmethod
    def setUpClass(cls):
        cls.run_of = Run(cls.run_folder, cls.truth)

    def test_the_run_has_enough_to_compare(self):
        self.assertGreater(len(self.run_of.stamps), 50)
        self.assertGreater(len(self.run_of.trajectories), 3)
        self.assertIsNotNone(self.run_of.from_stamp)

    def test_convergence(self):
        shown = self.run_of.summary["filter"]["converged_at_s"]
        self.assertAlmostEqual(self.run_of.from_stamp - self.run_of.start, shown, places=6)
        self.assertIn(f"converged after {shown:.1f} s", self.run_of.page)

    def test_comparison_table(self):
        run = self.run_of
        rows = {row[0]: row[1:] for row in run.table("methods")[0][1:]}
        self.assertEqual(set(rows), set(run.trajectories))
        for name, row in rows.items():
            errors, headings = run.counted(name), [h for h in run.counted(name, 2) if h is not None]
            self.assertEqual(int(row[0]), len(run.trajectories[name]), name)
            expected = {2: root_mean_square(errors), 4: quantile(errors, 0.5), 5: quantile(errors, 0.95),
                        6: max(errors), 8: root_mean_square([error[1] for error in run.errors[name].values()])}
            for column, value in expected.items():
                self.assertAlmostEqual(float(row[column]), value, delta=ROUNDED, msg=f"{name}, column {column}")
            self.assertAlmostEqual(float(row[7]), root_mean_square(headings), delta=6e-3, msg=name)

    def test_intervals(self):
        run = self.run_of
        shown = 0
        for row in run.table("methods")[0][1:]:
            errors = run.counted(row[0])
            if row[4] == "-":
                self.assertLess(len(errors), 50, row[0])
                continue
            low, high = (float(end) for end in row[4].split("–"))
            own_low, own_high = block_interval(errors)
            shown += 1
            self.assertAlmostEqual(low, own_low, delta=0.15 * (own_high - own_low) + ROUNDED, msg=row[0])
            self.assertAlmostEqual(high, own_high, delta=0.15 * (own_high - own_low) + ROUNDED, msg=row[0])
        self.assertGreater(shown, 2)

    def test_summary(self):
        run = self.run_of
        for name, method in run.summary["methods"].items():
            for key, errors in (("position_error_m", run.counted(name)),
                                ("position_error_whole_run_m", [e[1] for e in run.errors[name].values()])):
                mean = sum(errors) / len(errors)
                expected = {"rmse": root_mean_square(errors), "mean": mean, "median": quantile(errors, 0.5),
                            "std": root_mean_square([e - mean for e in errors]), "min": min(errors),
                            "max": max(errors), "p95": quantile(errors, 0.95)}
                for figure, value in expected.items():
                    self.assertAlmostEqual(method[key][figure], value, delta=1e-5, msg=f"{name} {key} {figure}")

    def test_sentences_on_accuracy(self):
        run = self.run_of
        sentences = re.findall(r"<li>(\w+) (?:is|cannot)[^<]* particle_filter[^<]*: RMSE ([\d.]+) times", run.page)
        self.assertGreater(len(sentences), 0)
        for name, shown in sentences:
            common = [s for s in run.errors[name] if s in run.errors["particle_filter"] and s >= run.from_stamp]
            ratio = (root_mean_square([run.errors[name][s][1] for s in common])
                     / root_mean_square([run.errors["particle_filter"][s][1] for s in common]))
            self.assertAlmostEqual(float(shown), ratio, delta=6e-3, msg=name)

    def test_error_curves(self):
        run = self.run_of
        for m, method in enumerate(run.data["methods"]):
            curve = {round(t + run.start): (p, h) for t, p, h in zip(
                run.data["errors"]["t"], run.data["errors"]["position"][m], run.data["errors"]["heading"][m])}
            self.assertEqual({s for s, (p, _) in curve.items() if p is not None}, set(run.errors[method["name"]]))
            for stamp, (_, position, heading) in run.errors[method["name"]].items():
                self.assertAlmostEqual(curve[stamp][0], position, delta=1e-4)
                if heading is not None:
                    self.assertAlmostEqual(curve[stamp][1], heading, delta=1e-3)

    def test_consistency(self):
        run = self.run_of
        nees = run.data["nees"]
        covariances = dict(zip((round(t + run.start) for t in nees["t"]), nees["covariance"]))
        errors = {}
        for t, x, y, phi in run.trajectories["particle_filter"]:
            truth = interpolate(run.truth, t, MAX_GAP)
            if truth:  # the last estimate of each second stays
                errors[math.ceil(t - 1e-9)] = x - truth[0], y - truth[1], wrap(phi - truth[2])
        values = {stamp: normalised_square(P, errors[stamp]) for stamp, P in covariances.items()}
        for stamp, shown in zip(covariances, nees["value"]):
            self.assertAlmostEqual(shown, values[stamp], delta=2e-3 + 2e-3 * values[stamp])
        counted = [value for stamp, value in values.items() if stamp >= run.from_stamp]
        figures = run.summary["filter"]["nees"]
        self.assertAlmostEqual(figures["mean"], sum(counted) / len(counted), delta=2e-3 * figures["mean"])
        freedom = 3 * len(counted)  # chi-square quantiles by Wilson and Hilferty
        for figure, normal in (("band_low", -1.959964), ("band_high", 1.959964)):
            quantile_of = freedom * (1 - 2 / (9 * freedom) + normal * math.sqrt(2 / (9 * freedom))) ** 3
            self.assertAlmostEqual(figures[figure], quantile_of / len(counted), delta=2e-3)
        facts = {row[0]: row[1] for table in run.table("facts") for row in table}
        shown = next(value for name, value in facts.items() if name.startswith("NEES"))
        self.assertEqual(shown, "{mean:.2f} ({band_low:.2f} to {band_high:.2f})".format(**figures))

    def test_errors_by_number_of_landmarks(self):
        run = self.run_of
        frames = sorted((t + run.start, len(set(self.landmarks_of(detections))))
                        for t, detections in zip(run.data["playback"]["t"], run.data["playback"]["detections"])
                        if detections)
        table = next(t for t in run.table("geometry") if t[0][0] == "landmarks in view")
        names = [cell for cell in table[0][2:]]
        charted = next(chart for chart in run.data["geometry"] if chart["quantity"] == "landmarks in view")
        column_of = {method["name"]: m for m, method in enumerate(run.data["methods"])}
        for row in table[1:]:
            if not row[0].isdigit():
                continue
            count = int(row[0])
            entry = charted["classes"].index(row[0])
            self.assertEqual(int(row[1]), sum(1 for t, n in frames if n == count and t >= run.from_stamp - 1e-6))
            for name, cell in zip(names, row[2:]):
                errors = [error[1] for stamp, error in run.errors[name].items() if stamp >= run.from_stamp
                          and self.frame_before(frames, error[0]) == count]
                shown = cell.split()[0]
                if errors and shown != "-":
                    self.assertAlmostEqual(float(shown), quantile(errors, 0.5), delta=ROUNDED, msg=f"{name} {count}")
                    for key, share in (("median", 0.5), ("p95", 0.95)):
                        value = charted[key][column_of[name]][entry]
                        self.assertAlmostEqual(value, quantile(errors, share), delta=1e-4, msg=f"{name} {count} {key}")

    @staticmethod
    def landmarks_of(detections):
        """Landmarks by index, anonymous detections one by one."""
        return [detections[i + 5] if detections[i + 5] >= 0 else ("anonymous", i) for i in range(0, len(detections), 7)]

    @staticmethod
    def frame_before(frames, time):
        known = [n for t, n in frames if time - 1 - 1e-3 <= t <= time + 1e-3]
        return known[-1] if known else None


if __name__ == "__main__":
    Figures.run_folder, Figures.truth = pathlib.Path(sys.argv[1]), sys.argv[2]
    unittest.main(argv=sys.argv[:1], verbosity=2)
