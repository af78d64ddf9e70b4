// Brings the page to life; without scripts it shows the same as tables and drawings that do not move.
import { createCharts } from './charts.js';
import { Playback } from './playback.js';
import { parseRun } from './run_data.js';
import { onThemeChange } from './theme.js';

const run = parseRun(document.getElementById('run-data').textContent);
let playback = null;
const charts = createCharts(run, (time) => playback && playback.goTo(time));
if (run.stepCount > 0) {
  playback = new Playback(run, (time) => charts.forEach((chart) => chart.setTime(time)));
  /** @type {HTMLElement} */ (document.querySelector('#map .static')).hidden = true;
}
onThemeChange(() => {
  charts.forEach((chart) => chart.recolour());
  if (playback) playback.show(playback.step);
});
