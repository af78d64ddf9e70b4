"""Opens reports of real runs in a headless Chromium and uses them as a reader does.

    test_report_page.py CHROMIUM RUN_FOLDER...

Every folder holds report.html and summary.json of one trial. Exit code 0: all is well; 77: no browser here."""

import json
import os
import pathlib
import re
import sys
import time
import unittest

from browser import SKIPPED, Browser

CANVAS = "document.getElementById('map-canvas')"
# How many pixels of the canvas are painted, and a number that changes with the picture.
PICTURE = f"""(() => {{
  const canvas = {CANVAS};
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  let painted = 0, mark = 0;
  for (let i = 3; i < pixels.length; i += 4) if (pixels[i] > 0) {{ ++painted; mark = (mark * 31 + i + pixels[i - 3]) >>> 0; }}
  return [painted, mark];
}})()"""
# Of every chart: its name, and how many of its pixels have a colour (grid, axes and text are grey, bands are pale).
CHARTS = """[...document.querySelectorAll('[data-chart]')].map((box) => {
  let coloured = 0;
  for (const canvas of box.querySelectorAll('canvas')) {
    const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    for (let i = 0; i < pixels.length; i += 4) {
      const r = pixels[i], g = pixels[i + 1], b = pixels[i + 2];
      if (pixels[i + 3] > 128 && Math.max(r, g, b) - Math.min(r, g, b) > 60) ++coloured;
    }
  }
  return [box.dataset.chart, coloured];
})"""
TABLE = """[...document.querySelectorAll('table.methods tbody tr')].map((row) => [...row.children].map((cell) => {
  const copy = cell.cloneNode(true);
  for (const badge of copy.querySelectorAll('.badge')) badge.remove();
  return copy.textContent.trim();
}))"""
READOUT = "document.getElementById('readout').textContent"
NO_FIGURE = "-"


def magnitude(value):
    """About four significant digits, as the report writes them."""
    if value is None:
        return NO_FIGURE
    size = abs(value)
    return f"{value:.{3 if size < 9.9995 else 2 if size < 99.995 else 1 if size < 999.95 else 0}f}"


def percent(share):
    if share is None:
        return NO_FIGURE
    if 0 < share < 0.005:
        return "<1 %"
    if 0.995 <= share < 1:
        return ">99 %"
    return f"{100 * share:.0f} %"


def fixed(value, decimals):
    return NO_FIGURE if value is None else f"{value:.{decimals}f}"


def set_slider(browser, step):
    browser.value(f"""(() => {{ const slider = document.getElementById('step-slider');
      slider.value = {step}; slider.dispatchEvent(new Event('input')); }})()""")
    browser.frame()


class ReportPage(unittest.TestCase):
    program = ""
    folders = []

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(cls.program)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()

    def open_each(self, width=1280, dark=False):
        for folder in self.folders:
            self.browser.scripts(True)
            self.browser.resize(width, 900, phone=width < 600)
            self.browser.dark(dark)
            self.browser.open(folder / "report.html")
            self.browser.frame()
            yield folder

    def test_the_browser_reports_no_errors_and_no_requests(self):
        for width in (1280, 400):
            for dark in (False, True):
                for _ in self.open_each(width, dark):
                    self.assertEqual(self.browser.complaints(), [])

    def test_fits_a_phone(self):
        for _ in self.open_each(400):
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), 400)
            self.assertGreater(self.browser.value(CANVAS + ".clientWidth"), 300)

    def test_charts_and_map_are_drawn_and_the_static_map_is_hidden(self):
        for folder in self.open_each():
            painted, _ = self.browser.value(PICTURE)
            self.assertGreater(painted, 2000)
            charts = self.browser.value(CHARTS)
            names = [name for name, _ in charts]
            for name in ("position", "heading", "confidence", "nees", "geometry", "residuals"):
                self.assertIn(name, names, folder.name)
            for name, coloured in charts:
                self.assertGreater(coloured, 100, f"{folder.name}: {name}")
            self.assertFalse(self.browser.value(
                "[...document.querySelectorAll('.static, noscript')].some((element) => element.offsetHeight > 0)"))

    def test_the_legend_hides_and_shows_a_series(self):
        for folder in self.open_each():
            for index, (name, before) in enumerate(self.browser.value(CHARTS)):
                click = (f"document.querySelectorAll('[data-chart]')[{index}]"
                         ".querySelectorAll('[data-series]').forEach((button, i) => "
                         "document.querySelectorAll('[data-chart]')[%d].querySelector(`[data-series=\"${i}\"]`).click())"
                         % index)
                self.browser.value(click)
                self.browser.frame()
                self.assertLess(self.browser.value(CHARTS)[index][1], before, f"{folder.name}: {name}")
                self.browser.value(click)
                self.browser.frame()
                self.assertEqual(self.browser.value(CHARTS)[index][1], before, f"{folder.name}: {name}")

    def test_pointing_at_a_chart_shows_values(self):
        for folder in self.open_each():
            for index, (name, _) in enumerate(self.browser.value(CHARTS)):
                box = f"document.querySelectorAll('[data-chart]')[{index}]"
                self.browser.value(box + ".scrollIntoView({block: 'center'})")
                area = self.browser.value(f"(() => {{ const r = {box}.querySelector('.plot').getBoundingClientRect();"
                                          " return [r.left, r.top, r.width, r.height]; })()")
                self.browser.command("Input.dispatchMouseEvent", type="mouseMoved", x=area[0] + 0.5 * area[2],
                                     y=area[1] + 0.5 * area[3])
                self.browser.frame()
                values = self.browser.value(f"[...{box}.querySelectorAll('.series b')].map((b) => b.textContent)")
                self.assertTrue(any(re.search(r"\d", value) for value in values), f"{folder.name}: {name}")

    def test_the_slider_moves_the_robot(self):
        for folder in self.open_each():
            last = int(self.browser.value("document.getElementById('step-slider').max"))
            self.assertGreater(last, 20)
            pictures, poses = set(), set()
            for step in (last // 3, last // 2, last):
                set_slider(self.browser, step)
                pictures.add(tuple(self.browser.value(PICTURE)))
                poses.add(re.search(r" at (.*? m)", self.browser.value(READOUT)).group(1))
            self.assertEqual(len(pictures), 3)
            self.assertEqual(len(poses), 3)
            self.assertEqual(self.browser.complaints(), [])

    def test_the_last_step_shows_the_last_estimate(self):
        for folder in self.open_each():
            set_slider(self.browser, 10**9)
            shown = re.search(r" at (-?[\d.]+), (-?[\d.]+) m", self.browser.value(READOUT))
            times = self.browser.value("JSON.parse(document.getElementById('run-data').textContent).playback.t")
            rows = [line.split() for line in (folder / "trajectory_particle_filter.tum").read_text().splitlines()]
            first = float((folder / "steps.csv").read_text().splitlines()[1].split(",")[0])
            at = min(rows, key=lambda row: abs(float(row[0]) - self.start_of(folder, first) - times[-1]))
            self.assertAlmostEqual(float(shown.group(1)), float(at[1]), delta=0.006)
            self.assertAlmostEqual(float(shown.group(2)), float(at[2]), delta=0.006)

    @staticmethod
    def start_of(folder, first):
        """Start of the log: the first frame is that far from it in the page's own data."""
        text = (folder / "report.html").read_text()
        data = json.loads(re.search(r'id="run-data">(.*?)</script>', text, re.S).group(1))
        return first - data["playback"]["t"][0]

    def test_keys_step_and_play(self):
        for folder in self.open_each():
            step = "Number(document.getElementById('step-slider').value)"
            self.browser.key("End")
            last = self.browser.value(step)
            self.browser.key("ArrowLeft")
            self.assertEqual(self.browser.value(step), last - 1)
            self.browser.key("Home")
            self.browser.key("ArrowRight")
            self.assertEqual(self.browser.value(step), 1)
            self.browser.value("document.getElementById('speed').value = '200'")
            self.browser.key(" ", " ")
            deadline = time.monotonic() + 60
            while self.browser.value(step) < last and time.monotonic() < deadline:
                self.browser.frame()
            self.assertEqual(self.browser.value(step), last)
            self.assertEqual(self.browser.value("document.querySelector('.play').textContent"), "▶")

    def test_layers_can_be_switched_off(self):
        for folder in self.open_each():
            before = self.browser.value(PICTURE)
            self.browser.value("document.querySelectorAll('#layers input').forEach((box) => box.checked && box.click())")
            self.browser.frame()
            self.assertLess(self.browser.value(PICTURE)[0], before[0])

    def test_the_table_equals_the_summary(self):
        for folder in self.open_each():
            summary = json.loads((folder / "summary.json").read_text())
            rows = {row[0]: row[1:] for row in self.browser.value(TABLE)}
            self.assertEqual(list(rows), list(summary["methods"]))
            for name, method in summary["methods"].items():
                position, heading = method["position_error_m"], method["heading_error_deg"]
                shown = rows[name]
                interval = shown.pop(3)
                self.assertEqual(shown, [
                    fixed(method["estimates"], 0), percent(method["availability"]), magnitude(position["rmse"]),
                    magnitude(position["median"]), magnitude(position["p95"]), magnitude(position["max"]),
                    fixed(heading["rmse"], 2), magnitude(method["position_error_whole_run_m"]["rmse"]),
                    *(fixed(method["time_per_step_ms"][figure], 3) for figure in ("median", "p99", "max"))], name)
                if interval != NO_FIGURE:
                    low, high = (float(end) for end in interval.split(" – "))
                    self.assertLessEqual(low, position["rmse"] + 5e-4)
                    self.assertGreaterEqual(high, position["rmse"] - 5e-4)
            self.assertIn(summary["verdict"], self.browser.value("document.querySelector('.verdict').className"))
            self.assertIn(summary["verdict_reason"], self.browser.value("document.body.textContent"))

    def test_tables_and_map_are_readable_without_scripts(self):
        for folder in self.open_each():
            charts = len(self.browser.value(CHARTS))
            self.browser.scripts(False)
            self.browser.open(folder / "report.html")
            self.assertEqual(self.browser.complaints(), [])
            root = self.browser.command("DOM.getDocument")["root"]["nodeId"]

            def nodes(selector):
                return self.browser.command("DOM.querySelectorAll", nodeId=root, selector=selector)["nodeIds"]

            def height(node):
                return self.browser.command("DOM.getBoxModel", nodeId=node)["model"]["height"]

            for selector in ("svg.map", "table.methods", "table.geometry", "table.provenance", "noscript p"):
                self.assertGreater(len(nodes(selector)), 0, selector)
                for node in nodes(selector):
                    self.assertGreater(height(node), 10, selector)
            html = self.browser.command("DOM.getOuterHTML", nodeId=root)["outerHTML"]
            self.assertEqual(html.count("This chart needs JavaScript."), charts)
            self.assertNotRegex(html, r'<div class="static" hidden')
            self.assertRegex(html, r'<div id="player" class="player" hidden')
            self.browser.scripts(True)

    def test_is_small_and_opens_fast(self):
        for folder in self.open_each():
            self.assertLess((folder / "report.html").stat().st_size, 2 << 20)
            timing = self.browser.value("performance.getEntriesByType('navigation')[0].loadEventEnd")
            print(f"{folder.name}: opened in {timing / 1000:.2f} s", flush=True)

    def test_a_picture_of_every_width_and_colour(self):
        """Kept where REPORT_PICTURES names a folder."""
        pictures = os.environ.get("REPORT_PICTURES")
        if not pictures:
            self.skipTest("REPORT_PICTURES is not set")
        pathlib.Path(pictures).mkdir(parents=True, exist_ok=True)
        for width in (1280, 400):
            for dark in (False, True):
                for folder in self.open_each(width, dark):
                    name = f"{folder.name}_{width}_{'dark' if dark else 'light'}.png"
                    self.browser.screenshot(pathlib.Path(pictures) / name)


if __name__ == "__main__":
    if len(sys.argv) < 3 or not pathlib.Path(sys.argv[1]).exists():
        print("no Chromium here (Debian: chromium): the page is not tested")
        sys.exit(SKIPPED)
    ReportPage.program = sys.argv[1]
    ReportPage.folders = [pathlib.Path(folder) for folder in sys.argv[2:]]
    unittest.main(argv=sys.argv[:1], verbosity=2)
