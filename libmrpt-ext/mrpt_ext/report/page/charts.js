// A chart drawn by Dygraphs: drag to zoom, double click to see everything, click to go to that time.
import { colour } from './theme.js';

export function shortNumber(value) {
  return Number(value.toPrecision(3)).toString();
}

/** Shaded areas below the curves. */
function fillAreas(ctx, area, graph, marks) {
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
}

/** Lines at values and times, and whiskers. */
function strokeMarks(ctx, area, graph, { marks, series }) {
  const stroke = (x1, y1, x2, y2, name, width, dash) => {
    ctx.strokeStyle = colour(name);
    ctx.lineWidth = width;
    ctx.setLineDash(dash);
    ctx.beginPath();
    ctx.moveTo(x1, y1);
    ctx.lineTo(x2, y2);
    ctx.stroke();
  };
  const atValue = (value, name) => {
    const y = graph.toDomYCoord(value);
    stroke(area.x, y, area.x + area.w, y, name, 1, [4, 4]);
  };
  const atTime = (time, name, dash) => {
    const x = graph.toDomXCoord(time);
    stroke(x, area.y, x, area.y + area.h, name, 1.5, dash);
  };
  if (marks.level) atValue(marks.level, 'quiet');
  if (typeof marks.converged === 'number') atTime(marks.converged, 'good', [2, 3]);
  for (const time of marks.reseeds || []) atTime(time, 'bad', []);
  const visible = graph.visibility();
  for (const { index, x, low, high } of marks.whiskers || []) {
    const at = graph.toDomXCoord(x);
    if (visible[index]) stroke(at, graph.toDomYCoord(low), at, graph.toDomYCoord(high), series[index].colour, 2, []);
  }
}

/** What is drawn below the curves, within the axes. */
function underlay(spec) {
  return (ctx, area, graph) => {
    ctx.save();
    ctx.beginPath();
    ctx.rect(area.x, area.y, area.w, area.h);
    ctx.clip();
    fillAreas(ctx, area, graph, spec.marks);
    strokeMarks(ctx, area, graph, spec);
    ctx.restore();
  };
}

/** Legend with the values below the pointer; its buttons show and hide the series. */
function legendOf(spec) {
  return (data) => {
    const pointed = data.x !== undefined;
    const items = data.series.map((entry, i) => {
      const value = pointed && spec.value ? spec.value(i, data.x) : entry.y;
      const text = value === undefined || value === null || Number.isNaN(value) ? '' : shortNumber(value);
      const off = entry.isVisible ? '' : ' off';
      return (
        `<li><button type="button" class="series${off}" data-series="${i}" aria-pressed="${entry.isVisible}">` +
        `<span class="key ${spec.series[i].symbol}" style="color:var(--${spec.series[i].colour})"></span>` +
        `${entry.labelHTML} <b>${text}</b></button></li>`
      );
    });
    const notes = (spec.notes || []).map((note) => `<li>${note}</li>`);
    const position = pointed ? `<li><b>${spec.positionText(data.x)}</b></li>` : '';
    return '<ul class="legend">' + items.join('') + notes.join('') + position + '</ul>';
  };
}

/** Swiping over a chart scrolls the page; a tap shows values. */
function interactionWithoutTouch() {
  const model = Object.assign({}, Dygraph.defaultInteractionModel);
  for (const name of ['touchstart', 'touchmove', 'touchend']) delete model[name];
  return model;
}

export class Chart {
  /** `spec`: {
   *    rows: [[x, value of each series], ...], series: [{label, colour, symbol, options}], unit, xlabel,
   *    window: [from, to] of the horizontal axis, range: [low, high] of the vertical one (else null), log,
   *    marks: {band, spans, level, converged, reseeds, whiskers}, notes: further entries of the legend,
   *    positionText(x), value(series, x): what the legend shows (else the value of the row), ticker: of x,
   *    timed: whether x is a time [s] }. `onPick(time)`: the reader clicked there. */
  constructor(box, spec, onPick) {
    this.spec = spec;
    this.time = null;
    const plot = document.createElement('div');
    plot.className = 'plot';
    const legend = document.createElement('div');
    box.append(plot, legend);
    this.cursor = document.createElement('div');
    this.cursor.className = 'cursor';
    this.cursor.hidden = true;
    this.graph = new Dygraph(plot, spec.rows, this.options(legend, onPick));
    plot.append(this.cursor);
    legend.addEventListener('click', (event) => {
      const button = /** @type {Element} */ (event.target).closest('[data-series]');
      if (!(button instanceof HTMLElement)) return;
      const index = Number(button.dataset.series);
      this.graph.setVisibility(index, !this.graph.visibility()[index]);
    });
  }

  options(legend, onPick) {
    const { spec } = this;
    const x = { axisLabelFormatter: shortNumber, pixelsPerLabel: 50 };
    return {
      labels: ['x', ...spec.series.map((s) => s.label)],
      series: Object.fromEntries(spec.series.map((s) => [s.label, s.options])),
      logscale: spec.log,
      valueRange: spec.range,
      dateWindow: spec.window,
      includeZero: !spec.log,
      ylabel: spec.unit + (spec.log ? ', logarithmic' : ''),
      xlabel: spec.xlabel,
      labelsDiv: legend,
      legend: 'always',
      legendFormatter: legendOf(spec),
      underlayCallback: underlay(spec),
      drawCallback: () => this.setTime(this.time),
      clickCallback: (_, time) => spec.timed && onPick(time),
      interactionModel: interactionWithoutTouch(),
      axes: {
        y: { axisLabelFormatter: shortNumber, axisLabelWidth: 44 },
        x: spec.ticker ? { ...x, ticker: spec.ticker } : x,
      },
      highlightCircleSize: 4,
      ...this.colours(),
    };
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
    if (!this.graph || !this.spec.timed || time === null) return;
    const area = this.graph.getArea();
    const x = this.graph.toDomXCoord(time);
    this.cursor.hidden = x < area.x || x > area.x + area.w;
    Object.assign(this.cursor.style, { left: x + 'px', top: area.y + 'px', height: area.h + 'px' });
  }
}
