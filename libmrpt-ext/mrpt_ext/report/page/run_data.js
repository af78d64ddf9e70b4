// The data of the run; see report/chart_data.h and report/playback_json.h for its form.

const kTurn = 2 * Math.PI;

/** Particles of all steps in common arrays; those of step s are first[s] ... first[s + 1] - 1. */
export function unpackParticles(packed) {
  const bytes = Uint8Array.from(atob(packed.poses), (c) => c.charCodeAt(0));
  const total = bytes.length / 4;
  const particles = {
    x: new Float32Array(total),
    y: new Float32Array(total),
    phi: new Float32Array(total),
    first: new Uint32Array(packed.counts.length + 1),
  };
  packed.counts.forEach((count, step) => {
    const first = particles.first[step];
    const [lowX, lowY, width, height] = packed.boxes.slice(4 * step, 4 * step + 4);
    for (let i = first; i < first + count; ++i) {
      const b = 4 * i;
      particles.x[i] = lowX + (width * ((bytes[b] << 4) | (bytes[b + 1] >> 4))) / 4095;
      particles.y[i] = lowY + (height * (((bytes[b + 1] & 15) << 8) | bytes[b + 2])) / 4095;
      particles.phi[i] = (kTurn * bytes[b + 3]) / 256;
    }
    particles.first[step + 1] = first + count;
  });
  return particles;
}

/** Pose at a step of [x, y, phi, x, y, phi, ...]; null where there is none. */
export function poseAt(poses, step) {
  const [x, y, phi] = poses.slice(3 * step, 3 * step + 3);
  return x === null || x === undefined ? null : { x, y, phi };
}

/** Groups of `size` numbers. */
export function groups(numbers, size) {
  const all = [];
  for (let i = 0; i < numbers.length; i += size) all.push(numbers.slice(i, i + size));
  return all;
}

/** The last step at or before a time [s], at least 0. */
export function stepAtTime(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (times[middle] <= time + 1e-6) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** A page over several trials has charts, but no playback. */
export function parseRun(text) {
  const run = JSON.parse(text);
  const judged = (run.methods || []).find((method) => method.name === run.judged);
  run.judgedColour = judged ? judged.colour : 'filter';
  run.stepCount = run.playback ? run.playback.t.length : 0;
  if (run.playback) run.particles = unpackParticles(run.playback.particles);
  return run;
}
