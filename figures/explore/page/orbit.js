// The orbit of the rotor's centre, in the stator's or the rotor's frame, for the part of the time
// that the plots show.
import { colour } from "./colours.js";
import { rowAt } from "./motion.js";

/// What lies to the right and what below: as in the paper, x_a points down.
const frames = {
  stator: { right: "y_a_m", down: "x_a_m", names: ["y_a", "x_a"] },
  rotor: { right: "q1_m", down: "q2_m", names: ["q1", "q2"] },
};

export class Orbit {
  #canvas;
  #frame = "stator";
  #picture = null;
  #behind = null;
  #part = [0, Infinity];
  #clearance_m = 0;
  #view = { right: 0, down: 0, zoom: 1 }; // the centre, m; 1: the ring's clearance fits
  #drawn = 0;

  constructor(canvas) {
    this.#canvas = canvas;
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.25 : 0.8, this.#place(event));
    }, { passive: false });
    this.#letDrag();
    canvas.addEventListener("dblclick", () => this.fit());
    canvas.addEventListener("keydown", (event) => this.#press(event));
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  show(picture, clearance_m) {
    this.#picture = picture;
    this.#clearance_m = clearance_m;
    this.draw();
  }
  /// Another picture, whose times are later by so much.
  showBehind(other) {
    this.#behind = other;
    this.draw();
  }
  showPart(from_s, until_s) {
    this.#part = [from_s, until_s];
    this.draw();
  }
  showFrame(name) {
    this.#frame = name;
    this.draw();
  }

  zoom(factor, place = this.#view) {
    const view = this.#view;
    view.right = place.right + (view.right - place.right) / factor;
    view.down = place.down + (view.down - place.down) / factor;
    view.zoom *= factor;
    this.draw();
  }
  fit() {
    this.#view = { right: 0, down: 0, zoom: 1 };
    this.draw();
  }

  /// With the next frame of the screen, however often it is asked for.
  draw() {
    this.#drawn ||= requestAnimationFrame(() => {
      this.#drawn = 0;
      if (this.#picture) this.#paint();
    });
  }

  /// Pixels of the screen in a metre.
  get #scale() {
    const fits = 1.25 * this.#clearance_m;
    return (this.#canvas.clientWidth / 2 / fits) * this.#view.zoom;
  }
  #place({ offsetX, offsetY }) {
    const { clientWidth, clientHeight } = this.#canvas;
    return { right: this.#view.right + (offsetX - clientWidth / 2) / this.#scale,
      down: this.#view.down + (offsetY - clientHeight / 2) / this.#scale };
  }

  #letDrag() {
    const canvas = this.#canvas;
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      this.#view.right -= event.movementX / this.#scale;
      this.#view.down -= event.movementY / this.#scale;
      this.draw();
    });
  }

  #press(event) {
    const step = 20 / this.#scale;
    const act = {
      "+": () => this.zoom(1.25), "-": () => this.zoom(0.8), 0: () => this.fit(),
      ArrowLeft: () => (this.#view.right -= step), ArrowRight: () => (this.#view.right += step),
      ArrowUp: () => (this.#view.down -= step), ArrowDown: () => (this.#view.down += step),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
    this.draw();
  }

  #paint() {
    const canvas = this.#canvas, ctx = canvas.getContext("2d");
    const { clientWidth: width, clientHeight: height } = canvas;
    canvas.width = width * devicePixelRatio;
    canvas.height = height * devicePixelRatio;
    ctx.scale(devicePixelRatio, devicePixelRatio);
    const { right, down } = this.#view, scale = this.#scale;
    const x = (right_m) => width / 2 + (right_m - right) * scale;
    const y = (down_m) => height / 2 + (down_m - down) * scale;

    ctx.strokeStyle = colour("text");
    ctx.setLineDash([3, 3]);
    ctx.beginPath();
    ctx.arc(x(0), y(0), this.#clearance_m * scale, 0, 2 * Math.PI);
    ctx.stroke();
    ctx.setLineDash([]);
    if (this.#behind) this.#paintCurve(ctx, this.#behind, x, y);
    this.#paintCurve(ctx, { picture: this.#picture, colour: "first", later_s: 0 }, x, y);
    paintScale(ctx, width, height, scale, frames[this.#frame].names);
  }

  #paintCurve(ctx, { picture: { motion }, colour: name, later_s }, x, y) {
    const frame = frames[this.#frame];
    const rights = motion[frame.right], downs = motion[frame.down];
    ctx.strokeStyle = colour(name);
    ctx.lineWidth = 1;
    ctx.beginPath();
    const [from_s, until_s] = this.#part.map((time_s) => time_s + later_s);
    const end = rowAt(motion.time_s, until_s);
    for (let row = rowAt(motion.time_s, from_s); row <= end; ++row)
      ctx.lineTo(x(rights[row]), y(downs[row]));
    ctx.stroke();
  }
}

/// A bar of a round length, and the axes' directions.
function paintScale(ctx, width, height, pixels_per_m, [right, down]) {
  const about_mm = (1e3 * width) / 4 / pixels_per_m;
  const decade = 10 ** Math.floor(Math.log10(about_mm));
  const length_mm = decade * [5, 2, 1].find((digit) => digit * decade <= about_mm);
  const pixels = (length_mm / 1e3) * pixels_per_m;
  ctx.fillStyle = ctx.strokeStyle = colour("text");
  ctx.font = "12px system-ui, sans-serif";
  ctx.beginPath();
  ctx.moveTo(10, height - 10);
  ctx.lineTo(10 + pixels, height - 10);
  ctx.stroke();
  ctx.fillText(`${Number(length_mm.toPrecision(1))} mm`, 10, height - 16);
  ctx.textAlign = "right";
  ctx.fillText(`${right} →`, width - 8, height - 10);
  ctx.fillText(`${down} ↓`, width - 8, height - 26);
}
