// Charts over time, drawn by Dygraphs: drag to zoom, double click for everything, click to go there.
import { colour } from './theme.js';

const kLogSpan = 30; // from this ratio of values on the axis is logarithmic
const kDecades = 5; // ... over at most

function shortNumber(value) {
  return Number(value.toPrecision(3)).toString();
}

/** Rows get an empty one where stamps are missing, so that no line runs across a gap. */
function withGaps(rows) {
  const steps = rows.slice(1).map((row, i) => row[0] - rows[i][0]);
  const usual = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 2)];
  const all = [];
  rows.forEach((row, i) => {
    if (i > 0 && steps[i - 1] > 4 * usual) all.push([rows[i - 1][0] + usual, ...row.slice(1).map(() => null)]);
    all.push(row);
  });
  return all;
}

/** Logarithmic when the values span far; values below the axis are drawn on it. */
function logScale(rows) {
  const values = rows.flatMap((row) => row.slice(1)).filter((v) => v !== null && v > 0).sort((a, b) => a - b);
  const largest = values[values.length - 1];
  const small = values[Math.floor(0.02 * values.length)];
  if (values.length === 0 || largest < kLogSpan * small) return { rows, logscale: false, range: null };
  const low = Math.max(10 ** Math.floor(Math.log10(small)), largest / 10 ** kDecades);
  return { rows: clamped(rows, [low, largest]), logscale: true, range: [low, 1.5 * largest] };
}

/** Rows with all values moved into a range. */
function clamped(rows, [low, high]) {
  const inside = (v) => (v === null ? v : Math.min(Math.max(v, low), high));
  return rows.map(([t, ...values]) => [t, ...values.map(inside)]);
}

/** Rows and value axis of a chart. */
function scaled(spec) {
  if (!spec.range) return logScale(spec.rows);
  return { rows: clamped(spec.rows, spec.range), logscale: spec.log, range: spec.range };
}

function verticalLine(ctx, area, x, style, dash) {
  ctx.strokeStyle = style;
  ctx.lineWidth = 1.5;
  ctx.setLineDash(dash);
  ctx.beginPath();
  ctx.moveTo(x, area.y);
  ctx.lineTo(x, area.y + area.h);
  ctx.stroke();
  ctx.setLineDash([]);
}

function horizontalLine(ctx, area, y, style) {
  ctx.strokeStyle = style;
  ctx.lineWidth = 1;
  ctx.setLineDash([4, 4]);
  ctx.beginPath();
  ctx.moveTo(area.x, y);
  ctx.lineTo(area.x + area.w, y);
  ctx.stroke();
  ctx.setLineDash([]);
}

/** Bands, spans and marks below the curves. */
function underlay(marks) {
  return (ctx, area, graph) => {
    ctx.save();
    ctx.beginPath();
    ctx.rect(area.x, area.y, area.w, area.h);
    ctx.clip();
    if (marks.band) {
      const top = graph.toDomYCoord(marks.band[1]);
      ctx.fillStyle = colour('band');
      ctx.fillRect(area.x, top, area.w, graph.toDomYCoord(marks.band[0]) - top);
    }
    for (const [spans, name] of marks.spans || [])
      for (const [from, to] of spans) {
        const x = graph.toDomXCoord(from);
        ctx.fillStyle = colour(name);
        ctx.fillRect(x, area.y, Math.max(graph.toDomXCoord(to) - x, 1), area.h);
      }
    if (marks.level) horizontalLine(ctx, area, graph.toDomYCoord(marks.level), colour('quiet'));
    if (marks.converged !== null && marks.converged !== undefined)
      verticalLine(ctx, area, graph.toDomXCoord(marks.converged), colour('good'), [2, 3]);
    for (const time of marks.reseeds || []) verticalLine(ctx, area, graph.toDomXCoord(time), colour('bad'), []);
    ctx.restore();
  };
}

function legendOf(series, notes) {
  return (data) => {
    const time = data.x === undefined ? '' : '<li><b>' + Number(data.x).toFixed(1) + ' s</b></li>';
    const items = data.series.map((entry, i) => {
      const value = entry.y === undefined || entry.y === null || Number.isNaN(entry.y) ? '' : shortNumber(entry.y);
      const off = entry.isVisible ? '' : ' off';
      return (
        `<li><button type="button" class="series${off}" data-series="${i}" aria-pressed="${entry.isVisible}">` +
        `<span class="key ${series[i].symbol}" style="color:var(--${series[i].colour})"></span>` +
        `${entry.labelHTML} <b>${value}</b></button></li>`
      );
    });
    return '<ul class="legend">' + items.join('') + notes.map((note) => `<li>${note}</li>`).join('') + time + '</ul>';
  };
}

/** Swiping over a chart scrolls the page; a tap shows values. */
function interactionWithoutTouch() {
  const model = Object.assign({}, Dygraph.defaultInteractionModel);
  for (const name of ['touchstart', 'touchmove', 'touchend']) delete model[name];
  return model;
}

class TimeChart {
  /** `spec`: {unit, rows, series: [{label, colour, symbol, options}], marks, notes}, with a `range` of values to show
   *  also whether it is `log`. */
  constructor(box, spec, run, onPick) {
    this.spec = spec;
    const plot = document.createElement('div');
    plot.className = 'plot';
    const legend = document.createElement('div');
    box.append(plot, legend);
    this.cursor = document.createElement('div');
    this.cursor.className = 'cursor';
    const { rows, logscale, range } = scaled(spec);
    this.graph = new Dygraph(plot, withGaps(rows), {
      labels: ['time', ...spec.series.map((s) => s.label)],
      series: Object.fromEntries(spec.series.map((s) => [s.label, s.options])),
      logscale,
      valueRange: range,
      dateWindow: [0, run.duration || 1],
      includeZero: !logscale,
      ylabel: spec.unit + (logscale ? ', logarithmic' : ''),
      xlabel: 's since the start of the log',
      labelsDiv: legend,
      legend: 'always',
      legendFormatter: legendOf(spec.series, spec.notes || []),
      underlayCallback: underlay(spec.marks),
      drawCallback: () => this.setTime(this.time),
      clickCallback: (_, x) => onPick(x),
      interactionModel: interactionWithoutTouch(),
      axes: { y: { axisLabelFormatter: shortNumber, axisLabelWidth: 44 }, x: { axisLabelFormatter: shortNumber, pixelsPerLabel: 50 } },
      highlightCircleSize: 4,
      ...this.colours(),
    });
    plot.append(this.cursor);
    this.time = null;
    legend.addEventListener('click', (event) => {
      const button = /** @type {Element} */ (event.target).closest('[data-series]');
      if (!(button instanceof HTMLElement)) return;
      const index = Number(button.dataset.series);
      this.graph.setVisibility(index, !this.graph.visibility()[index]);
    });
    /** @type {HTMLElement} */ (box.querySelector('.static')).hidden = true;
  }

  colours() {
    return {
      colors: this.spec.series.map((s) => colour(s.colour)),
      axisLineColor: colour('quiet'),
      gridLineColor: colour('line'),
    };
  }

  recolour() {
    this.graph.updateOptions(this.colours());
  }

  /** Puts the cursor at a time [s]. */
  setTime(time) {
    this.time = time;
    if (!this.graph || time === null || time === undefined) return;
    const area = this.graph.getArea();
    const x = this.graph.toDomXCoord(time);
    this.cursor.hidden = x < area.x || x > area.x + area.w;
    Object.assign(this.cursor.style, { left: x + 'px', top: area.y + 'px', height: area.h + 'px' });
  }
}

function methodSeries(run, columns) {
  const series = [];
  const kept = [];
  run.methods.forEach((method, m) => {
    if (!columns[m].some((value) => value !== null)) return;
    kept.push(columns[m]);
    const judged = method.name === run.judged;
    const odometry = method.name === 'odometry';
    series.push({
      label: method.name,
      colour: method.colour,
      symbol: method.continuous ? (odometry ? 'dash' : 'line') : method.oracle ? 'dot oracle' : 'dot',
      options: method.continuous
        ? { strokeWidth: judged ? 2.6 : 1.6, strokePattern: odometry ? [6, 4] : null }
        : { strokeWidth: 0, drawPoints: true, pointSize: method.oracle ? 2 : 2.8 },
    });
  });
  return { series, rows: run.errors.t.map((t, i) => [t, ...kept.map((column) => column[i])]) };
}

function errorSpec(run, name, unit, level) {
  const notes = [];
  if (run.converged !== null) notes.push('<span class="key bar good"></span>converged');
  if (level !== null) notes.push('<span class="key dash quiet"></span>limit');
  if (run.errors.joined > 1) notes.push('worst of ' + run.errors.joined + ' stamps each');
  return { ...methodSeries(run, run.errors[name]), unit, notes, marks: { level, converged: run.converged } };
}

/** Weights of the three heaviest modes and effective sample ratio, wherever either is known. */
function confidenceSpec(run) {
  const { confidence, playback } = run;
  const rows = new Map(confidence.t.map((t, i) => [t, [t, confidence.ess[i], confidence.weight[i], null, null]]));
  playback.t.forEach((t, step) => {
    const weights = playback.modes[step].filter((_, i) => i % 7 === 3);
    const row = rows.get(t) || [t, null, null, null, null];
    row[3] = weights.length > 1 ? weights[1] : null;
    row[4] = weights.length > 2 ? weights[2] : null;
    rows.set(t, row);
  });
  const colourOf = (name) => run.methods.find((m) => m.name === name).colour;
  const points = { strokeWidth: 0, drawPoints: true, pointSize: 2 };
  const all = [
    { label: 'effective sample ratio', colour: 'form-1', symbol: 'line', options: { strokeWidth: 1.2 } },
    { label: 'heaviest mode', colour: colourOf(run.judged), symbol: 'line', options: { strokeWidth: 2.4 } },
    { label: 'second', colour: 'mode', symbol: 'dot', options: points },
    { label: 'third', colour: 'form-3', symbol: 'dot', options: points },
  ];
  const sorted = [...rows.values()].sort((a, b) => a[0] - b[0]);
  const used = all.map((_, i) => sorted.some((row) => row[i + 1] !== null));
  const notes = [];
  if (confidence.reseeds.length > 0)
    notes.push(`<span class="key bar"></span>re-seeded (${confidence.reseeds.length} times)`);
  for (const verdict of ['ambiguous', 'lost'])
    if (confidence[verdict].length > 0) notes.push(`<span class="key area ${verdict}"></span>verdict ${verdict}`);
  return {
    series: all.filter((_, i) => used[i]),
    rows: sorted.map((row) => row.filter((_, i) => i === 0 || used[i - 1])),
    unit: 'share',
    range: [0, 1.03],
    log: false,
    notes,
    marks: {
      spans: [
        [confidence.ambiguous, 'span-ambiguous'],
        [confidence.lost, 'span-lost'],
      ],
      reseeds: confidence.reseeds,
    },
  };
}

function neesSpec(run) {
  const { t, value, low, high, mean } = run.nees;
  const judged = run.methods.find((m) => m.name === run.judged);
  const notes = ['<span class="key area band"></span>95 % of honest estimates'];
  if (mean !== null) notes.push('<span class="key dash quiet"></span>mean ' + shortNumber(mean));
  return {
    series: [{ label: 'NEES of ' + judged.name, colour: judged.colour, symbol: 'line', options: { strokeWidth: 1.6 } }],
    rows: t.map((time, i) => [time, value[i]]),
    unit: 'NEES',
    range: [0.02, 1000], // what lies outside is drawn on the edge
    log: true,
    notes,
    marks: { band: [low, high], level: mean, converged: run.converged },
  };
}

/** All charts that the page has a place for. */
export function createCharts(run, onPick) {
  const specs = {
    position: () => errorSpec(run, 'position', 'm', run.limit_m),
    heading: () => errorSpec(run, 'heading', 'deg', run.limit_deg),
    confidence: () => run.confidence && confidenceSpec(run),
    nees: () => run.nees && neesSpec(run),
  };
  const charts = [];
  for (const box of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-chart]'))) {
    const spec = specs[box.dataset.chart]();
    if (spec && spec.rows.length > 1 && spec.series.length > 0) charts.push(new TimeChart(box, spec, run, onPick));
  }
  return charts;
}
