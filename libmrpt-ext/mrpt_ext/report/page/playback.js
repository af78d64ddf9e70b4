// The controls below the map: slider, buttons, keys, layers, and the text line.
import { MapView } from './map_view.js';
import { poseAt, stepAtTime } from './run_data.js';

const kShownFor = 40; // [s] of a whole run at the initial speed

function textAt(run, step) {
  const { playback } = run;
  const facts = ['<b>' + playback.t[step].toFixed(2) + ' s</b>'];
  const pose = run.judged ? poseAt(playback.methods[run.judged], step) : null;
  if (pose) {
    const heading = pose.phi === null ? '' : ', ' + ((pose.phi * 180) / Math.PI).toFixed(1) + '°';
    facts.push(run.judged + ' at ' + pose.x.toFixed(2) + ', ' + pose.y.toFixed(2) + ' m' + heading);
  }
  const truth = poseAt(playback.truth, step);
  if (pose && truth) facts.push('error ' + Math.hypot(pose.x - truth.x, pose.y - truth.y).toFixed(3) + ' m');
  const weights = playback.modes[step].filter((_, i) => i % 7 === 3);
  if (weights.length > 1) facts.push(weights.length + ' modes, the heaviest ' + Math.round(100 * weights[0]) + ' %');
  const detections = playback.detections[step].length / 7;
  facts.push(detections === 1 ? '1 detection' : detections + ' detections');
  return facts.join(' · ');
}

export class Playback {
  /** `onStep(time)` is called with the time of each step shown [s]. */
  constructor(run, onStep) {
    this.run = run;
    this.onStep = onStep;
    this.step = 0;
    this.playing = false;
    this.slider = /** @type {HTMLInputElement} */ (document.getElementById('step-slider'));
    this.slider.max = String(run.stepCount - 1);
    this.readout = document.getElementById('readout');
    this.speed = /** @type {HTMLSelectElement} */ (document.getElementById('speed'));
    document.getElementById('player').hidden = false;
    this.map = new MapView(run, document.getElementById('map-canvas'));
    this.actions = {
      first: () => this.show(0),
      back: () => this.show(this.step - 1),
      play: () => this.toggle(),
      forward: () => this.show(this.step + 1),
      last: () => this.show(run.stepCount - 1),
      'zoom-in': () => this.map.zoom(1.4),
      'zoom-out': () => this.map.zoom(1 / 1.4),
      fit: () => {
        this.follow(false);
        this.map.fit();
      },
      follow: () => this.follow(!this.map.follow),
    };
    this.chooseSpeed();
    this.listen();
    this.listLayers();
    this.show(0);
  }

  chooseSpeed() {
    const wanted = this.run.duration / kShownFor;
    const fast = [...this.speed.options].filter((option) => Number(option.value) >= wanted);
    this.speed.value = (fast[0] || this.speed.options[this.speed.options.length - 1]).value;
  }

  listen() {
    this.slider.addEventListener('input', () => this.show(Number(this.slider.value)));
    for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#player button')))
      button.addEventListener('click', () => this.actions[button.dataset.action]());
    document.addEventListener('keydown', (event) => this.key(event));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.matches('select, input, textarea, a, summary, button') && event.target !== this.slider) return;
    const far = event.shiftKey ? 10 : 1;
    const keys = {
      ' ': () => this.toggle(),
      ArrowLeft: () => this.show(this.step - far),
      ArrowRight: () => this.show(this.step + far),
      Home: () => this.show(0),
      End: () => this.show(this.run.stepCount - 1),
      '+': this.actions['zoom-in'],
      '-': this.actions['zoom-out'],
      0: this.actions.fit,
      f: this.actions.follow,
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }

  follow(on) {
    this.map.follow = on;
    document.querySelector('#player [data-action=follow]').setAttribute('aria-pressed', String(on));
    this.map.draw(this.step);
  }

  /** The legend switches the layers. */
  listLayers() {
    const list = document.getElementById('layers');
    for (const layer of [...this.map.list].reverse()) {
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = layer.on;
      box.addEventListener('change', () => {
        layer.on = box.checked;
        this.map.draw(this.step);
      });
      const key = document.createElement('span');
      key.className = 'key ' + layer.symbol;
      key.style.color = 'var(--' + layer.colour + ')';
      const label = document.createElement('label');
      label.append(box, key, layer.label);
      const item = document.createElement('li');
      item.append(label);
      list.append(item);
    }
  }

  show(step) {
    this.step = Math.min(Math.max(step, 0), this.run.stepCount - 1);
    this.slider.value = String(this.step);
    this.slider.setAttribute('aria-valuetext', this.run.playback.t[this.step].toFixed(2) + ' seconds');
    this.map.draw(this.step);
    this.readout.innerHTML = textAt(this.run, this.step);
    this.onStep(this.run.playback.t[this.step]);
  }

  goTo(time) {
    this.show(stepAtTime(this.run.playback.t, time));
  }

  toggle() {
    this.playing = !this.playing;
    document.querySelector('#player .play').textContent = this.playing ? '❚❚' : '▶';
    if (!this.playing) return;
    if (this.step === this.run.stepCount - 1) this.show(0);
    this.clock = { time: this.run.playback.t[this.step], at: performance.now() };
    requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    if (!this.playing) return;
    const time = this.clock.time + (Number(this.speed.value) * (now - this.clock.at)) / 1000;
    this.clock = { time, at: now };
    const step = stepAtTime(this.run.playback.t, time);
    if (step > this.step) this.show(step);
    else if (step < this.step) this.clock.time = this.run.playback.t[this.step]; // the slider was moved
    if (this.step === this.run.stepCount - 1) this.toggle();
    else requestAnimationFrame((next) => this.tick(next));
  }
}
