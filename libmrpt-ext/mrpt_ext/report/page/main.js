// Draws the charts and starts the playback. Without scripts the page shows the tables and a static map.
import { geometrySpec, residualSpec } from './category_charts.js';
import { Chart } from './charts.js';
import { Playback } from './playback.js';
import { parseRun } from './run_data.js';
import { onThemeChange } from './theme.js';
import { biasSpec, confidenceSpec, errorSpec, neesSpec } from './time_charts.js';

const kSpecs = {
  position: (run) => errorSpec(run, 'position', 'm', run.limit_m),
  heading: (run) => errorSpec(run, 'heading', 'deg', run.limit_deg),
  confidence: confidenceSpec,
  nees: neesSpec,
  bias: biasSpec,
  geometry: geometrySpec,
  residuals: residualSpec,
};

const run = parseRun(document.getElementById('run-data').textContent);
let playback = null;
const boxes = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-chart]'));
const charts = [...boxes].flatMap((box) => {
  const spec = kSpecs[box.dataset.chart](run, Number(box.dataset.index || 0));
  if (spec.rows.length > 0) return [new Chart(box, spec, (time) => playback && playback.goTo(time))];
  box.textContent = 'No data.';
  return [];
});
if (run.stepCount > 0) {
  playback = new Playback(run, (time) => charts.forEach((chart) => chart.setTime(time)));
  /** @type {HTMLElement} */ (document.querySelector('#map .static')).hidden = true;
}
onThemeChange(() => {
  charts.forEach((chart) => chart.recolour());
  if (playback) playback.show(playback.step);
});
