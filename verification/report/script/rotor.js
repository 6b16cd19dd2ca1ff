// The rotor in its ring at a time of a run: as on paper x_a points down and y_a to the right, and
// angles turn from x_a to y_a.
import { arrow, cleared, colour, onChanged } from "./colours.js";
import { inWords, rowAt, stateAt, whirlAt } from "./motion.js";

const gap = 0.22; // drawn width of the clearance, relative to the ring's radius
const trail_s = 0.004; // length of the trail of O
const caption = 22; // height of the words below, in pixels
const full_N = 464e3; // has the longest arrow, unless a run has a larger force: the accident's

export class RotorView {
  #canvas;
  #words;
  picture = null; // goTo paints it
  #time_s = 0;

  /// Draws on a canvas, and describes state and time in words.
  constructor(canvas, words) {
    this.#canvas = canvas;
    this.#words = words;
    onChanged(canvas, () => this.paint());
  }
  goTo(time_s) {
    this.#time_s = time_s;
    this.paint();
  }

  paint() {
    if (!this.picture) return;
    const { motion, mass_loss_s: loss_s, summary } = this.picture;
    const now = stateAt(motion, this.#time_s);
    this.#words.textContent = inWords(now, loss_s);
    if (this.#canvas.clientWidth === 0) return;
    const { ctx, width, height } = cleared(this.#canvas);
    ctx.translate(width / 2, (height - caption) / 2);
    const ring = 0.39 * Math.min(width, height - caption),
      radius = ring * (1 - gap);
    const clearance_m = summary.inputs.stator_radius - summary.inputs.rotor_radius;
    const pixels_per_m = (ring * gap) / clearance_m;
    const at = ({ x_a_m, y_a_m }) => [y_a_m * pixels_per_m, x_a_m * pixels_per_m];
    const centre = at(now),
      lost = this.#time_s >= loss_s,
      loses = summary.lost_mass_kg > 0;
    const touches = now.normal_force_N < 0;
    paintRing(ctx, ring);
    paintRotor(ctx, centre, radius, now.q3_rad, loses && (lost ? "lost" : "held"));
    const behind = [];
    const last = rowAt(motion.time_s, this.#time_s);
    for (let row = rowAt(motion.time_s, this.#time_s - trail_s); row < last; ++row)
      behind.push(at({ x_a_m: motion.x_a_m[row], y_a_m: motion.y_a_m[row] }));
    const ink = summary.equations; // the colour of what the run does
    paintTrail(ctx, [...behind, centre], ink);
    paintTurn(ctx, centre, 0.42 * radius, 1, "spin", `spin ${now.speed_Hz.toFixed(0)} Hz`, "text");
    const whirl_Hz = whirlAt(motion, this.#time_s);
    if (touches && Math.abs(whirl_Hz) > 1)
      paintTurn(
        ctx,
        [0, 0],
        1.16 * ring,
        Math.sign(whirl_Hz),
        "whirl",
        `whirl ${width < 350 ? "" : "now "}${Math.abs(whirl_Hz).toFixed(0)} Hz`,
        ink,
        Math.atan2(centre[1], centre[0]),
      );
    if (touches) paintForce(ctx, now, ring, summary.peak_normal_force_N, ink);
    ctx.fillStyle = colour("quiet");
    ctx.textAlign = "center";
    ctx.fillText(
      "clearance drawn " +
        `${((summary.inputs.stator_radius * gap) / clearance_m).toFixed(1)} times as wide`,
      0,
      (height + caption) / 2 - 6,
    );
  }
}

function paintRing(ctx, ring) {
  ctx.fillStyle = colour("ring");
  ctx.beginPath();
  ctx.arc(0, 0, 1.09 * ring, 0, 2 * Math.PI);
  ctx.arc(0, 0, ring, 0, 2 * Math.PI, true);
  ctx.fill();
  ctx.fillStyle = colour("quiet");
  ctx.fillRect(-4, -0.5, 8, 1);
  ctx.fillRect(-0.5, -4, 1, 8);
}

const half_piece = 0.15; // rad

/// The mass centre is on the rotor's axis x; a piece that is "held" or "lost", which leaves a notch,
/// is on the opposite side.
function paintRotor(ctx, [x, y], radius, angle, piece) {
  const notch = Math.PI / 2 - angle + Math.PI; // in the sense of the canvas
  const half = piece === "lost" ? half_piece : 0;
  ctx.fillStyle = colour("rotor");
  ctx.strokeStyle = colour("text");
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  ctx.arc(x, y, radius, notch + half, notch + 2 * Math.PI - half);
  if (half) ctx.lineTo(x + 0.84 * radius * Math.cos(notch), y + 0.84 * radius * Math.sin(notch));
  ctx.closePath();
  ctx.fill();
  ctx.stroke();
  if (piece !== "held") return;
  ctx.fillStyle = colour("text");
  ctx.beginPath();
  ctx.moveTo(x + 0.84 * radius * Math.cos(notch), y + 0.84 * radius * Math.sin(notch));
  ctx.arc(x, y, radius, notch - half_piece, notch + half_piece);
  ctx.fill();
}

function paintTrail(ctx, points, ink) {
  ctx.strokeStyle = ctx.fillStyle = colour(ink);
  ctx.lineWidth = 2;
  for (let n = 1; n < points.length; ++n) {
    ctx.globalAlpha = (n / points.length) ** 2;
    ctx.beginPath();
    ctx.moveTo(...points[n - 1]);
    ctx.lineTo(...points[n]);
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
  ctx.beginPath();
  ctx.arc(...points.at(-1), 4, 0, 2 * Math.PI);
  ctx.fill();
}

/// An arrow along a circle: with the rotation, which is against the canvas's angle, or against it.
function paintTurn(ctx, [x, y], radius, sense, name, text, ink, begin = 0) {
  const length = name === "spin" ? 1.6 * Math.PI : 0.9,
    points = [];
  for (let n = 0; n <= 24; ++n) {
    const angle = begin - sense * ((n / 24) * length + (name === "spin" ? 0.6 * Math.PI : 0.08));
    points.push([x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
  }
  ctx.strokeStyle = ctx.fillStyle = colour(ink);
  ctx.lineWidth = name === "spin" ? 2 : 4;
  arrow(ctx, points, name === "spin" ? 8 : 12);
  ctx.textAlign = "center";
  ctx.font = "600 13px system-ui, sans-serif";
  if (name === "spin") {
    // away from the contact, and readable on the trail
    const place = [text, x, y + (y > 0 ? -1.75 : 1.9) * radius];
    ctx.strokeStyle = colour("rotor");
    ctx.lineWidth = 5;
    ctx.strokeText(...place);
    ctx.fillText(...place);
  } else {
    const side = points[12][0] > 0 ? -1 : 1,
      { clientWidth: wide, clientHeight: high } = ctx.canvas; // away from the arrow
    ctx.textAlign = side < 0 ? "left" : "right";
    ctx.fillText(text, (side * wide) / 2, 12 - (high - caption) / 2);
  }
  ctx.font = "12px system-ui, sans-serif";
}

/// The ring's force on the rotor: inwards, and along the rim by friction (positive in the sense of
/// q3).
function paintForce(ctx, now, ring, peak_N, ink) {
  const { x_a_m, y_a_m, normal_force_N: normal, friction_force_N: friction } = now;
  const rho = Math.hypot(x_a_m, y_a_m),
    n = [y_a_m / rho, x_a_m / rho];
  const scale = (0.75 * ring) / Math.max(peak_N, full_N),
    contact = n.map((part) => part * ring);
  ctx.strokeStyle = ctx.fillStyle = colour(ink);
  ctx.lineWidth = 4;
  arrow(
    ctx,
    [contact, forceTip(contact, n, normal * scale, friction * scale)],
    Math.min(12, 4 - normal * scale),
  );
}
export const forceTip = ([x, y], [right, down], normal, friction) => [
  x + normal * right + friction * down,
  y + normal * down - friction * right,
];
