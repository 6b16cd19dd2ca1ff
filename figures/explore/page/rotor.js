// The rotor in its ring, moved by the data of a run, in slow motion.
import { colour } from "./colours.js";
import { inWords, stateAt } from "./motion.js";

const gap = 0.16; // how wide the clearance is drawn, in parts of the ring's radius

export class RotorView {
  #canvas;
  #told;
  #onTime;
  #picture = null;
  #ring = { clearance_m: 1, radius_m: 1 };
  #part = [0, 1];
  #time_s = 0;
  #slowness = 300;
  #playing = false;
  #last_ms = null;

  /// Shows on a canvas, tells state and time in words, and the time to whoever follows it.
  constructor(canvas, told, onTime) {
    this.#canvas = canvas;
    this.#told = told;
    this.#onTime = onTime;
    new ResizeObserver(() => this.#paint()).observe(canvas);
  }

  show(picture, ring) {
    this.#picture = picture;
    this.#ring = ring;
    this.goTo(this.#time_s);
  }
  showPart(from_s, until_s) {
    this.#part = [from_s, until_s];
    this.goTo(this.#time_s);
  }
  set slowness(times) {
    this.#slowness = times;
    this.#paint();
  }
  get playing() {
    return this.#playing;
  }
  set playing(on) {
    this.#playing = on;
    this.#last_ms = null;
    if (on) requestAnimationFrame((now_ms) => this.#step(now_ms));
  }

  /// To a time inside of what is shown.
  goTo(time_s) {
    const [from, until] = this.#part;
    this.#time_s = time_s >= from && time_s <= until ? time_s : from;
    this.#paint();
    this.#onTime(this.#time_s);
  }

  #step(now_ms) {
    if (!this.#playing) return;
    const passed_s = this.#last_ms === null ? 0 : (now_ms - this.#last_ms) / 1e3;
    this.#last_ms = now_ms;
    if (this.#picture && !document.hidden) this.goTo(this.#time_s + Math.min(passed_s, 0.1) / this.#slowness);
    requestAnimationFrame((next_ms) => this.#step(next_ms));
  }

  #paint() {
    if (!this.#picture) return;
    const canvas = this.#canvas, ctx = canvas.getContext("2d");
    const size = canvas.clientWidth;
    canvas.width = canvas.height = size * devicePixelRatio;
    ctx.scale(devicePixelRatio, devicePixelRatio);
    ctx.translate(size / 2, size / 2);
    const now = stateAt(this.#picture.motion, this.#time_s);
    const ring = 0.44 * size, rotor = ring * (1 - gap);
    const pixels_per_m = (ring * gap) / this.#ring.clearance_m;
    // x_a points down, y_a to the right; angles turn from x_a to y_a.
    const centre = [now.y_a_m * pixels_per_m, now.x_a_m * pixels_per_m];
    paintRing(ctx, ring, size);
    const lost = this.#picture.mass_loss_s !== null && this.#time_s >= this.#picture.mass_loss_s;
    paintRotor(ctx, centre, rotor, now.q3_rad, lost);
    if (now.normal_force_N < 0) {
      const peak = Math.max(1, this.#picture.summary.peak_normal_force_N ?? 1);
      paintContact(ctx, Math.atan2(now.x_a_m, now.y_a_m), ring, -now.normal_force_N / peak);
    }
    const enlarged = ((this.#ring.radius_m + this.#ring.clearance_m) * gap) / this.#ring.clearance_m;
    this.#told.textContent = `${inWords(now)}; ${this.#slowness} times slower than real, ` +
      `the clearance enlarged ${enlarged.toFixed(1)} times`;
  }
}

function paintRing(ctx, radius, size) {
  ctx.fillStyle = colour("ring");
  ctx.beginPath();
  ctx.arc(0, 0, 0.49 * size, 0, 2 * Math.PI);
  ctx.arc(0, 0, radius, 0, 2 * Math.PI, true);
  ctx.fill();
}

/// The mass centre lies along the rotor's axis x; the piece that is lost leaves the other side.
function paintRotor(ctx, [x, y], radius, angle, lost) {
  const of_x = Math.PI / 2 - angle; // as the canvas counts
  ctx.fillStyle = colour("rotor");
  ctx.strokeStyle = colour("text");
  ctx.beginPath();
  const half_piece = lost ? 0.16 : 0;
  ctx.arc(x, y, radius, of_x + Math.PI + half_piece, of_x + 3 * Math.PI - half_piece);
  if (lost) ctx.lineTo(x + 0.88 * radius * Math.cos(of_x + Math.PI), y + 0.88 * radius * Math.sin(of_x + Math.PI));
  ctx.closePath();
  ctx.fill();
  ctx.stroke();
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.lineTo(x + 0.8 * radius * Math.cos(of_x), y + 0.8 * radius * Math.sin(of_x));
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(x, y, 3, 0, 2 * Math.PI);
  ctx.fillStyle = colour("text");
  ctx.fill();
}

/// The force on the rotor, as long as it is large beside the largest.
function paintContact(ctx, direction, ring, share) {
  const [c, s] = [Math.cos(direction), Math.sin(direction)];
  const tip = ring * (1 - 0.6 * share);
  ctx.strokeStyle = ctx.fillStyle = colour("event");
  ctx.lineWidth = 3;
  ctx.beginPath();
  ctx.moveTo(ring * c, ring * s);
  ctx.lineTo(tip * c, tip * s);
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(ring * c, ring * s, 5, 0, 2 * Math.PI);
  ctx.fill();
}
