// Charts over categories: errors by geometry, residuals by landmark.

const kErrorDecades = 5; // a logarithmic axis shows at most
const kCharacter = 7; // [pixels] of an axis label

/** Dots over labelled categories. `series`: [{label, colour, symbol, values, whiskers: [[low, high], ...]}], in which a
 *  value may be null; dots of one category stand side by side. */
function categorySpec(labels, series, spec) {
  const offset = (s) => ((s - (series.length - 1) / 2) * Math.min(0.1, 0.8 / series.length));
  const rows = [];
  const whiskers = [];
  labels.forEach((_, c) =>
    series.forEach(({ values, whiskers: ends }, s) => {
      if (values[c] === null) return;
      const x = c + offset(s);
      rows.push([x, ...series.map((_, other) => (other === s ? values[c] : null))]);
      whiskers.push({ index: s, x, low: ends[c][0], high: ends[c][1] });
    }),
  );
  const widest = kCharacter * Math.max(...labels.map((label) => label.length + 1));
  const labelOf = (x) => labels[Math.min(Math.max(Math.round(x), 0), labels.length - 1)];
  return {
    ...spec,
    rows,
    series: series.map((s) => ({ ...s, options: { strokeWidth: 0, drawPoints: true, pointSize: 4 } })),
    window: [-0.6, labels.length - 0.4],
    marks: { ...spec.marks, whiskers },
    positionText: labelOf,
    value: (s, x) => series[s].values[Math.round(x)],
    ticker: (from, to, pixels) => {
      const first = Math.max(Math.ceil(from), 0);
      const last = Math.min(Math.floor(to), labels.length - 1);
      const step = Math.max(Math.ceil((widest * (to - from)) / pixels), 1);
      const ticks = [];
      for (let c = first; c <= last; c += step) ticks.push({ v: c, label: labels[c] });
      return ticks;
    },
    timed: false,
  };
}

/** Median position error of every method in each class, whiskers up to the 95 % quantile. */
export function geometrySpec(run, index) {
  const { quantity, classes, median, p95 } = run.geometry[index];
  const shown = run.methods.map((_, m) => m).filter((m) => median[m] && median[m].some((v) => v !== null));
  const series = shown.map((m) => ({
    label: run.methods[m].name,
    colour: run.methods[m].colour,
    symbol: 'dot',
    values: median[m].map((v) => v || null), // zero has no place on a logarithmic axis
    whiskers: median[m].map((v, c) => [v, p95[m][c]]),
  }));
  const errors = series.flatMap((s) => s.values).filter((v) => v !== null);
  const least = Math.min(1, ...errors);
  const most = Math.max(least, ...series.flatMap((s) => s.whiskers.map((ends) => ends[1] || 0)));
  const high = 10 ** Math.ceil(Math.log10(most));
  const low = Math.max(Math.min(10 ** Math.floor(Math.log10(least)), high / 10), high / 10 ** kErrorDecades);
  return categorySpec(classes, series, { unit: 'm', xlabel: quantity, range: [low, high], log: true });
}

/** Mean residual of every landmark, whiskers of one standard deviation to either side. */
export function residualSpec(run) {
  const { ids, mean, std, warning } = run.residuals;
  const most = Math.max(...mean.map((m, i) => Math.abs(m) + std[i]));
  const reach = Math.min(Math.max(2 * Math.ceil(most / 2), 2), 10);
  const part = (label, colour, isPart) => ({
    label,
    colour,
    symbol: 'dot',
    values: mean.map((m, i) => (isPart(warning[i]) ? m : null)),
    whiskers: mean.map((m, i) => [m - std[i], m + std[i]]),
  });
  const series = [part('landmarks', 'filter', (text) => text === ''), part('with a warning', 'bad', (text) => text !== '')];
  return categorySpec(ids, series.filter((s) => s.values.some((v) => v !== null)), {
    unit: 'residual / standard deviation',
    xlabel: 'landmark',
    range: [-reach, reach],
    log: false,
    marks: { band: [-1, 1] },
  });
}
