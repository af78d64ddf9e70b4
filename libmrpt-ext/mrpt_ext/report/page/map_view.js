// The canvas of the map: layers, zoom and drag.
import { drawDots, drawLandmarks, drawModes, drawObjects, drawParticles, drawTrajectory, drawRobot, drawScale, drawDetections } from './map_layers.js';
import { poseAt } from './run_data.js';
import { Viewport } from './viewport.js';

const kTallest = 640; // [pixels]

/** Layers from the lowest to the uppermost: {label, colour, symbol, on, draw(ctx, view, step)}. */
function layersOf(run) {
  const list = [];
  const add = (label, colour, symbol, draw, on = true) => list.push({ label, colour, symbol, draw, on });
  const { playback, stepCount } = run;
  const observer = (step) => {
    const judged = run.judged ? poseAt(playback.methods[run.judged], step) : null;
    return judged || poseAt(playback.truth, step);
  };
  const any = (rows) => rows.some((row) => row.length > 0);
  const hasPoses = (poses) => poses.some((value) => value !== null);
  const closedForms = run.methods.filter((m) => !m.continuous && hasPoses(playback.methods[m.name]));
  const tracked = run.methods.filter((m) => m.continuous && m.aligned && hasPoses(playback.methods[m.name]));

  add('landmarks', 'quiet', 'triangle', (ctx, view) => drawLandmarks(ctx, view, run));
  if (any(playback.detections))
    add('bearings and ranges', 'detection', 'line', (ctx, view, step) =>
      drawDetections(ctx, view, run, step, observer(step)));
  for (const method of closedForms) {
    const style = { colour: method.colour, square: method.oracle };
    const draw = (ctx, view, step) => drawDots(ctx, view, step, playback.methods[method.name], style);
    add(method.name, method.colour, method.oracle ? 'dot oracle' : 'dot', draw, !method.oracle);
  }
  if (run.particles.first[stepCount] > 0)
    add('particles', 'particle', 'dots', (ctx, view, step) => drawParticles(ctx, view, run, step));
  for (const method of tracked) {
    const judged = method.name === run.judged;
    const odometry = method.name === 'odometry';
    const style = { colour: method.colour, width: judged ? 2.4 : 1.5, dash: odometry ? [6, 4] : [] };
    const poses = playback.methods[method.name];
    const draw = (ctx, view, step) => {
      drawTrajectory(ctx, view, run, step, poses, style);
      if (!judged) drawRobot(ctx, view, poseAt(poses, step), { colour: method.colour, hollow: true });
    };
    add(method.name, method.colour, odometry ? 'dash' : 'line', draw, judged || odometry || tracked.length < 4);
  }
  if (hasPoses(playback.truth))
    add('ground truth', 'text', 'line thin', (ctx, view, step) => {
      drawTrajectory(ctx, view, run, step, playback.truth, { colour: 'text', width: 1.2 });
      drawRobot(ctx, view, poseAt(playback.truth, step), { colour: 'text', hollow: true });
    });
  if (any(playback.modes))
    add('modes, 2 sigma', 'mode', 'ring mode', (ctx, view, step) => drawModes(ctx, view, run, step));
  if (any(playback.objects))
    add('detected objects', 'object', 'dot', (ctx, view, step) => drawObjects(ctx, view, run, step));
  if (run.judged)
    add('estimated pose', run.methods.find((m) => m.name === run.judged).colour, 'arrow', (ctx, view, step) =>
      drawRobot(ctx, view, poseAt(playback.methods[run.judged], step), {
        colour: run.methods.find((m) => m.name === run.judged).colour,
      }));
  return { list, observer };
}

export class MapView {
  constructor(run, canvas) {
    this.canvas = canvas;
    this.ctx = canvas.getContext('2d');
    this.view = new Viewport(run.extent);
    const { list, observer } = layersOf(run);
    this.list = list;
    this.observer = observer; // pose that the detections are drawn from
    this.step = 0;
    this.follow = false;
    this.touched = false;
    this.drag();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  resize() {
    const width = this.canvas.parentElement.clientWidth;
    if (width === 0) return;
    const height = this.view.heightFor(width, Math.min(kTallest, 1.2 * width));
    const density = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.canvas.style.height = height + 'px';
    this.ctx.setTransform(density, 0, 0, density, 0, 0);
    this.view.resize(width, height);
    if (!this.touched) this.view.fit();
    this.draw(this.step);
  }

  draw(step) {
    this.step = step;
    const robot = this.observer(step);
    if (this.follow && robot) this.view.centre = { x: robot.x, y: robot.y };
    this.ctx.clearRect(0, 0, this.view.width, this.view.height);
    for (const layer of this.list) if (layer.on) layer.draw(this.ctx, this.view, step);
    drawScale(this.ctx, this.view);
  }

  zoom(factor) {
    this.touched = true;
    this.view.zoom(factor);
    this.draw(this.step);
  }

  fit() {
    this.touched = false;
    this.follow = false;
    this.view.fit();
    this.draw(this.step);
  }

  drag() {
    let from = null;
    this.canvas.addEventListener('pointerdown', (event) => {
      if (event.pointerType === 'touch' && !this.touched) return; // a swipe scrolls the page until the map is zoomed
      from = event;
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (!from) return;
      this.touched = true;
      this.view.pan(event.clientX - from.clientX, event.clientY - from.clientY);
      from = event;
      this.draw(this.step);
    });
    for (const end of ['pointerup', 'pointercancel']) this.canvas.addEventListener(end, () => (from = null));
  }
}
