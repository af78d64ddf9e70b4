// What the map shows, one drawing function per layer.
import { colour } from './theme.js';
import { groups, poseAt } from './run_data.js';

const kJump = 0.08; // of the map's diagonal: a jump of the estimate, not a motion of the robot
const kSigmas = 2;
const kMostNames = 80;

function jumpOf(run) {
  const [lowX, lowY, highX, highY] = run.extent;
  return kJump * Math.hypot(highX - lowX, highY - lowY);
}

/** One line through the poses of the steps `from` to `to`, with gaps where there are none. */
function strokeTrajectory(ctx, view, poses, from, to, jump) {
  let last = null;
  ctx.beginPath();
  for (let step = from; step <= to; ++step) {
    const pose = poseAt(poses, step);
    if (pose && last && Math.hypot(pose.x - last.x, pose.y - last.y) < jump) ctx.lineTo(view.x(pose.x), view.y(pose.y));
    else if (pose) ctx.moveTo(view.x(pose.x), view.y(pose.y));
    last = pose;
  }
  ctx.stroke();
}

/** The trajectory so far, and faintly the rest of it. */
export function drawTrajectory(ctx, view, run, step, poses, style) {
  ctx.strokeStyle = colour(style.colour);
  ctx.lineWidth = style.width;
  ctx.setLineDash(style.dash || []);
  ctx.globalAlpha = 0.25;
  strokeTrajectory(ctx, view, poses, step, run.stepCount - 1, jumpOf(run));
  ctx.globalAlpha = 1;
  strokeTrajectory(ctx, view, poses, 0, step, jumpOf(run));
  ctx.setLineDash([]);
}

/** Single estimates: all so far as dots, the present one larger. */
export function drawDots(ctx, view, step, poses, style) {
  ctx.fillStyle = colour(style.colour);
  for (let s = 0; s <= step; ++s) {
    const pose = poseAt(poses, s);
    if (!pose) continue;
    const size = s === step ? 5 : 2.2;
    ctx.globalAlpha = s === step ? 1 : 0.45;
    ctx.beginPath();
    if (style.square) ctx.rect(view.x(pose.x) - size, view.y(pose.y) - size, 2 * size, 2 * size);
    else ctx.arc(view.x(pose.x), view.y(pose.y), size, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.globalAlpha = 1;
}

/** A robot: an arrow head along its heading, a disc where none is known. */
export function drawRobot(ctx, view, pose, style) {
  if (!pose) return;
  ctx.save();
  ctx.translate(view.x(pose.x), view.y(pose.y));
  ctx.beginPath();
  if (pose.phi === null) {
    ctx.arc(0, 0, 7, 0, 2 * Math.PI);
  } else {
    ctx.rotate(-pose.phi);
    ctx.moveTo(13, 0);
    ctx.lineTo(-8, 8);
    ctx.lineTo(-4, 0);
    ctx.lineTo(-8, -8);
    ctx.closePath();
  }
  ctx.lineWidth = 2;
  ctx.fillStyle = style.hollow ? colour('card') : colour(style.colour);
  ctx.strokeStyle = style.hollow ? colour(style.colour) : colour('card');
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}

export function drawLandmarks(ctx, view, run) {
  ctx.font = '11px system-ui, sans-serif';
  ctx.textAlign = 'left';
  for (const [x, y, id, , warning] of run.landmarks) {
    const px = view.x(x);
    const py = view.y(y);
    ctx.beginPath();
    ctx.moveTo(px, py - 6);
    ctx.lineTo(px + 6, py + 5);
    ctx.lineTo(px - 6, py + 5);
    ctx.closePath();
    ctx.fillStyle = colour(warning ? 'bad' : 'quiet');
    ctx.fill();
    if (id === '' || run.landmarks.length > kMostNames) continue;
    ctx.strokeStyle = colour('card');
    ctx.lineWidth = 3;
    ctx.strokeText(id, px + 8, py + 4);
    ctx.fillStyle = colour('text');
    ctx.fillText(id, px + 8, py + 4);
  }
}

export function drawParticles(ctx, view, run, step) {
  const { x, y, phi, first } = run.particles;
  const ticks = new Path2D();
  ctx.fillStyle = ctx.strokeStyle = colour('particle');
  ctx.globalAlpha = 0.6;
  for (let i = first[step]; i < first[step + 1]; ++i) {
    const px = view.x(x[i]);
    const py = view.y(y[i]);
    ctx.fillRect(px - 1.3, py - 1.3, 2.6, 2.6);
    ticks.moveTo(px, py);
    ticks.lineTo(px + 7 * Math.cos(phi[i]), py - 7 * Math.sin(phi[i]));
  }
  ctx.lineWidth = 0.8;
  ctx.globalAlpha = 0.35;
  ctx.stroke(ticks);
  ctx.globalAlpha = 1;
}

function ellipseOf(cxx, cxy, cyy) {
  const mean = (cxx + cyy) / 2;
  const half = Math.hypot((cxx - cyy) / 2, cxy);
  return {
    major: Math.sqrt(Math.max(mean + half, 0)),
    minor: Math.sqrt(Math.max(mean - half, 0)),
    angle: Math.atan2(2 * cxy, cxx - cyy) / 2,
  };
}

export function drawModes(ctx, view, run, step) {
  const modes = groups(run.playback.modes[step], 7);
  ctx.font = '11px system-ui, sans-serif';
  ctx.textAlign = 'center';
  for (const [x, y, phi, weight, cxx, cxy, cyy] of modes) {
    const { major, minor, angle } = ellipseOf(cxx, cxy, cyy);
    const px = view.x(x);
    const py = view.y(y);
    ctx.strokeStyle = ctx.fillStyle = colour('mode');
    ctx.lineWidth = 2;
    ctx.beginPath();
    const radius = (sigma) => Math.max(4, kSigmas * sigma * view.scale);
    ctx.ellipse(px, py, radius(major), radius(minor), -angle, 0, 2 * Math.PI);
    ctx.globalAlpha = 0.05 + 0.25 * weight;
    ctx.fill();
    ctx.globalAlpha = 0.45 + 0.55 * weight;
    ctx.stroke();
    ctx.beginPath();
    ctx.moveTo(px, py);
    ctx.lineTo(px + 16 * Math.cos(phi), py - 16 * Math.sin(phi));
    ctx.stroke();
    ctx.globalAlpha = 1;
    if (modes.length === 1) continue;
    const text = weight < 0.01 ? '<1 %' : Math.round(100 * weight) + ' %';
    ctx.strokeStyle = colour('card');
    ctx.lineWidth = 3;
    ctx.strokeText(text, px, py - 11);
    ctx.fillStyle = colour('text');
    ctx.fillText(text, px, py - 11);
  }
}

function strokeCircle(ctx, view, x, y, radius, width, dash) {
  ctx.lineWidth = width;
  ctx.setLineDash(dash);
  ctx.beginPath();
  ctx.arc(view.x(x), view.y(y), radius * view.scale, 0, 2 * Math.PI);
  ctx.stroke();
  ctx.setLineDash([]);
}

/** Bearings as rays, ranges as circles around the landmark (around the sensor for an anonymous one), a running fix as a
 *  thick ring. `pose`: of the robot. */
export function drawDetections(ctx, view, run, step, pose) {
  const [lowX, lowY, highX, highY] = run.extent;
  const far = 0.35 * Math.hypot(highX - lowX, highY - lowY);
  ctx.strokeStyle = colour('detection');
  for (const [mx, my, yaw, bearing, range, index, fix] of groups(run.playback.detections[step], 7)) {
    const landmark = index >= 0 ? run.landmarks[index] : null;
    ctx.globalAlpha = 0.75;
    if (range !== null && landmark)
      strokeCircle(ctx, view, landmark[0], landmark[1], range, fix ? 4 : 1.2, fix ? [] : [5, 4]);
    if (!pose || pose.phi === null) continue;
    const x = pose.x + Math.cos(pose.phi) * mx - Math.sin(pose.phi) * my;
    const y = pose.y + Math.sin(pose.phi) * mx + Math.cos(pose.phi) * my;
    if (range !== null && !landmark && bearing === null) strokeCircle(ctx, view, x, y, range, 1.2, [2, 4]);
    if (bearing === null) continue;
    const direction = pose.phi + yaw + bearing;
    const length = range !== null ? range : landmark ? Math.hypot(landmark[0] - x, landmark[1] - y) : far;
    ctx.lineWidth = 1.4;
    ctx.beginPath();
    ctx.moveTo(view.x(x), view.y(y));
    ctx.lineTo(view.x(x + length * Math.cos(direction)), view.y(y + length * Math.sin(direction)));
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
}

/** Objects that are no landmarks: estimated positions so far, the latest with their label. */
export function drawObjects(ctx, view, run, step) {
  ctx.font = '11px system-ui, sans-serif';
  ctx.textAlign = 'left';
  ctx.fillStyle = colour('object');
  for (let s = 0; s <= step; ++s) {
    const present = s === step;
    ctx.globalAlpha = present ? 1 : 0.25;
    for (const [x, y, label] of groups(run.playback.objects[s], 3)) {
      ctx.beginPath();
      ctx.arc(view.x(x), view.y(y), present ? 5 : 2, 0, 2 * Math.PI);
      ctx.fill();
      if (present) ctx.fillText(run.playback.object_labels[label], view.x(x) + 8, view.y(y) + 4);
    }
  }
  ctx.globalAlpha = 1;
}

/** A bar of 1, 2 or 5 times a power of ten metres. */
export function drawScale(ctx, view) {
  const wanted = view.width / view.scale / 5;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const metres = decade * (wanted / decade >= 5 ? 5 : wanted / decade >= 2 ? 2 : 1);
  const x = 14;
  const y = view.height - 12;
  ctx.strokeStyle = ctx.fillStyle = colour('text');
  ctx.lineWidth = 1.6;
  ctx.beginPath();
  ctx.moveTo(x, y - 5);
  ctx.lineTo(x, y);
  ctx.lineTo(x + metres * view.scale, y);
  ctx.lineTo(x + metres * view.scale, y - 5);
  ctx.stroke();
  ctx.font = '11px system-ui, sans-serif';
  ctx.textAlign = 'center';
  ctx.fillText(metres + ' m', x + (metres * view.scale) / 2, y - 6);
}
