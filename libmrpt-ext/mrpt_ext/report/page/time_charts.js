// Charts over time: errors, modes and effective sample size, consistency, biases.
import { shortNumber } from './charts.js';

const kLogSpan = 30; // from this ratio of values on the axis is logarithmic
const kDecades = 5; // ... over at most
const kNeesRange = [0.02, 1000]; // values outside are drawn on the edge

/** Inserts an empty row where stamps are missing, so that no line runs across a gap. */
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

/** Rows with all values moved into a range. */
function clamped(rows, low, high) {
  const inside = (v) => (v === null ? v : Math.min(Math.max(v, low), high));
  return rows.map(([t, ...values]) => [t, ...values.map(inside)]);
}

/** Logarithmic when the values span far; values below the axis are drawn on it. */
function errorScale(rows) {
  const values = rows.flatMap((row) => row.slice(1)).filter((v) => v !== null && v > 0).sort((a, b) => a - b);
  const largest = values[values.length - 1];
  const small = values[Math.floor(0.02 * values.length)];
  if (values.length === 0 || largest < kLogSpan * small) return { rows, log: false, range: null };
  const low = Math.max(10 ** Math.floor(Math.log10(small)), largest / 10 ** kDecades);
  return { rows: clamped(rows, low, largest), log: true, range: [low, 1.5 * largest] };
}

function timeSpec(run, spec) {
  return {
    log: false,
    range: null,
    marks: {},
    ...spec,
    rows: withGaps(spec.rows),
    window: [0, run.duration || 1],
    xlabel: 's since the start of the log',
    positionText: (t) => Number(t).toFixed(1) + ' s',
    timed: true,
  };
}

/** Methods that track as lines, closed forms as dots. */
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

export function errorSpec(run, name, unit, level) {
  const notes = [];
  if (run.converged !== null) notes.push('<span class="key bar good"></span>converged');
  if (level !== null) notes.push('<span class="key dash quiet"></span>limit');
  if (run.errors.stamps_per_entry > 1) notes.push(`each point: worst of ${run.errors.stamps_per_entry} stamps`);
  const { series, rows } = methodSeries(run, run.errors[name]);
  return timeSpec(run, { series, ...errorScale(rows), unit, notes, marks: { level, converged: run.converged } });
}

/** Weights of the three heaviest modes and effective sample ratio, wherever either is known. */
export function confidenceSpec(run) {
  const { confidence, playback } = run;
  const rows = new Map(confidence.t.map((t, i) => [t, [t, confidence.ess[i], confidence.weight[i], null, null]]));
  playback.t.forEach((t, step) => {
    const weights = playback.modes[step].filter((_, i) => i % 7 === 3);
    const row = rows.get(t) || [t, null, null, null, null];
    row[3] = weights.length > 1 ? weights[1] : null;
    row[4] = weights.length > 2 ? weights[2] : null;
    rows.set(t, row);
  });
  const points = { strokeWidth: 0, drawPoints: true, pointSize: 2 };
  const all = [
    { label: 'effective sample ratio', colour: 'form-1', symbol: 'line', options: { strokeWidth: 1.2 } },
    { label: 'heaviest mode', colour: run.judgedColour, symbol: 'line', options: { strokeWidth: 2.4 } },
    { label: 'second mode', colour: 'mode', symbol: 'dot', options: points },
    { label: 'third mode', colour: 'form-3', symbol: 'dot', options: points },
  ];
  const sorted = [...rows.values()].sort((a, b) => a[0] - b[0]);
  const used = all.map((_, i) => sorted.some((row) => row[i + 1] !== null));
  const notes = [];
  if (confidence.reseeds.length > 0)
    notes.push(`<span class="key bar"></span>reseeded (${confidence.reseeds.length} times)`);
  for (const verdict of ['ambiguous', 'lost'])
    if (confidence[verdict].length > 0) notes.push(`<span class="key area ${verdict}"></span>verdict ${verdict}`);
  const spans = [
    [confidence.ambiguous, 'span-ambiguous'],
    [confidence.lost, 'span-lost'],
  ];
  return timeSpec(run, {
    series: all.filter((_, i) => used[i]),
    rows: sorted.map((row) => row.filter((_, i) => i === 0 || used[i - 1])),
    unit: 'weight',
    range: [0, 1.03],
    notes,
    marks: { spans, reseeds: confidence.reseeds },
  });
}

export function neesSpec(run) {
  const { t, value, low, high, mean } = run.nees;
  const notes = ['<span class="key area band"></span>95 % of consistent estimates'];
  if (mean !== null) notes.push('<span class="key dash quiet"></span>mean ' + shortNumber(mean));
  const options = { strokeWidth: 1.6 };
  return timeSpec(run, {
    series: [{ label: 'NEES of ' + run.judged, colour: run.judgedColour, symbol: 'line', options }],
    rows: clamped(t.map((time, i) => [time, value[i]]), kNeesRange[0], kNeesRange[1]),
    unit: 'NEES',
    range: kNeesRange,
    log: true,
    notes,
    marks: { band: [low, high], level: mean, converged: run.converged },
  });
}

/** Mean of a bias and one standard deviation to either side. */
export function biasSpec(run, index) {
  const { t, mean, std } = run.biases[index];
  const limit = { strokeWidth: 1, strokePattern: [4, 4] };
  return timeSpec(run, {
    series: [
      { label: 'estimate', colour: run.judgedColour, symbol: 'line', options: { strokeWidth: 2.4 } },
      { label: '− 1 standard deviation', colour: 'quiet', symbol: 'dash', options: limit },
      { label: '+ 1 standard deviation', colour: 'quiet', symbol: 'dash', options: limit },
    ],
    rows: t.map((time, i) => [time, mean[i], mean[i] - std[i], mean[i] + std[i]]),
    unit: 'bias',
  });
}
