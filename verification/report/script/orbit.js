// The path of the rotor's centre in the time shown, in the stator's or the rotor's axes.
import { cleared, colour } from "./colours.js";
import { inRotorAxes, rowAt, stateAt } from "./motion.js";
import { zooms } from "./settings.js";

/// Coordinates to the right and downwards: as in the paper, x_a points down.
const frames = {
  stator: { names: ["yₐ", "xₐ"], at: ({ x_a_m, y_a_m }) => [y_a_m, x_a_m] },
  rotating: { names: ["q₁", "q₂"], at: inRotorAxes },
};
const bright_s = 0.003; // the path just before the present time

export class Orbit {
  #canvas;
  #frame = "stator";
  #picture = null;
  #part = [0, Infinity];
  #time_s = 0;

  constructor(canvas) {
    this.#canvas = canvas;
    this.zoom = 1;
    canvas.addEventListener("keydown", ({ key }) => {
      const factor = { "+": 1.25, "-": 0.8 }[key];
      if (factor) this.enlarge(factor);
    });
    new ResizeObserver(() => this.paint()).observe(canvas);
  }
  /// goTo paints it.
  show(picture, time_s) {
    this.#picture = picture;
    this.#time_s = time_s;
  }
  showPart(from_s, until_s) {
    this.#part = [from_s, until_s];
    this.paint();
  }
  goTo(time_s) {
    this.#time_s = time_s;
    this.paint();
  }
  enlarge(factor) {
    this.zoom = Math.min(zooms[1], Math.max(zooms[0], this.zoom * factor));
    this.paint();
  }
  set frame(name) {
    this.#frame = name;
    this.paint();
  }

  paint() {
    if (!this.#picture || this.#canvas.hidden) return;
    const { motion, summary: { inputs } } = this.#picture;
    const { ctx, width, height } = cleared(this.#canvas);
    const clearance_m = inputs.stator_radius - inputs.rotor_radius, { names, at } = frames[this.#frame];
    const scale = (Math.min(width, height) / 2 / (1.3 * clearance_m)) * this.zoom;
    const place = (state) => at(state).map((length, i) => [width, height][i] / 2 + length * scale);
    const path = (from_s, until_s) => {
      ctx.beginPath();
      for (let row = rowAt(motion.time_s, from_s); row <= rowAt(motion.time_s, until_s); ++row)
        ctx.lineTo(...place({ x_a_m: motion.x_a_m[row], y_a_m: motion.y_a_m[row], q3_rad: motion.q3_rad[row] }));
      ctx.stroke();
    };
    ctx.strokeStyle = colour("text");
    ctx.setLineDash([3, 3]);
    ctx.beginPath();
    ctx.arc(width / 2, height / 2, clearance_m * scale, 0, 2 * Math.PI);
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.strokeStyle = colour("draw");
    path(...this.#part);
    ctx.strokeStyle = ctx.fillStyle = colour("first");
    ctx.lineWidth = 2;
    path(this.#time_s - bright_s, this.#time_s);
    ctx.beginPath();
    ctx.arc(...place(stateAt(motion, this.#time_s)), 4, 0, 2 * Math.PI);
    ctx.fill();
    paintScale(ctx, width, height, scale, names);
  }
}

/// A bar of a round length, and the axes' directions.
function paintScale(ctx, width, height, pixels_per_m, [right, down]) {
  const about_mm = (1e3 * width) / 4 / pixels_per_m;
  const decade = 10 ** Math.floor(Math.log10(about_mm));
  const length_mm = decade * [5, 2, 1].find((digit) => digit * decade <= about_mm);
  ctx.fillStyle = colour("text");
  ctx.fillRect(10, height - 10, (length_mm / 1e3) * pixels_per_m, 1.5);
  ctx.fillText(`${Number(length_mm.toPrecision(1))} mm; dashed: the clearance`, 10, height - 16);
  ctx.textAlign = "right";
  ctx.fillText(`${right} →`, width - 8, height - 10);
  ctx.fillText(`${down} ↓`, width - 8, height - 26);
}
