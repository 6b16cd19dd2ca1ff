// Distance, force and speed over milliseconds after the loss, below bands of the kinds of motion.
// What a run shows has the colour of its equations.
import { bandsOf } from "./bands.js";
import { cleared, colour, onChanged, onDragged } from "./colours.js";
import { panels, ticks } from "./curves.js";
import { inMilliseconds } from "./motion.js";

const left = 50,
  right = 10,
  top = 24,
  bottom = 36;
const band_colours = { flight: "page", impacts: "bouncing" }; // others have an outcome's name

export class Plots {
  #canvas;
  #picture = null;
  #runs = []; // the picture's, and that of the other equations
  #drawn = []; // panels with the columns of each run
  part = [0, 1];
  #width = 0; // of the panels; the canvas has to lay out the page to know its own
  #time_s = 0;
  #still = document.createElement("canvas"); // everything except the time marker
  #onTime;

  panels = panels; // shown

  /// `onTime(s)` is called with the time pointed at. Without it the canvas is only a picture, whose
  /// axes fit the part shown.
  constructor(canvas, onTime) {
    this.#canvas = canvas;
    this.#onTime = onTime;
    onChanged(canvas, () => this.paint());
    if (!onTime) return;
    const timeAt = ({ offsetX }) =>
      this.part[0] + ((offsetX - left) / this.#width) * (this.part[1] - this.part[0]);
    onDragged(canvas, (event) => onTime(timeAt(event)));
    canvas.addEventListener("keydown", (event) => this.#press(event));
  }

  /// A second run gives the curves of other equations. Of several panels those without any values
  /// are left out.
  show([picture, ...others], part, time_s) {
    this.#picture = picture;
    this.#runs = [picture, ...others];
    this.#drawn = this.panels
      .map((panel) => ({
        ...panel,
        columns: this.#runs.map((run) => panel.curves.map((curve) => curve.of(run))),
      }))
      .filter(
        ({ columns }, n, { length }) =>
          length === 1 || columns.flat().some((values) => values.some((value) => value)),
      );
    this.#time_s = time_s;
    this.showPart(...part);
  }
  /// Shows a part of the run, at least a tenth of a millisecond.
  showPart(from_s, until_s) {
    const least = this.#picture.from_s,
      greatest = Math.max(...this.#runs.map((run) => run.until_s));
    const length = Math.min(Math.max(until_s - from_s, 1e-4), greatest - least);
    const begin = Math.min(Math.max(from_s, least), greatest - length);
    this.part = [begin, begin + length];
    this.paint();
  }
  stretch(factor) {
    const [from, until] = this.part,
      about_s = this.#time_s;
    this.showPart(about_s + factor * (from - about_s), about_s + factor * (until - about_s));
  }
  markNow(time_s) {
    const is_new = time_s !== this.#time_s,
      [from, until] = this.part;
    this.#time_s = time_s;
    if (time_s < from || time_s > until)
      this.showPart(time_s - (until - from) / 2, time_s + (until - from) / 2);
    else if (is_new) this.#paintNow();
  }

  #x(time_s) {
    return left + ((time_s - this.part[0]) / (this.part[1] - this.part[0])) * this.#width;
  }

  #press(event) {
    const [from, until] = this.part,
      step = (until - from) / 200;
    const to = {
      ArrowLeft: this.#time_s - step,
      ArrowRight: this.#time_s + step,
      PageDown: this.#time_s - 20 * step,
      PageUp: this.#time_s + 20 * step,
      Home: from,
      End: until,
    }[event.key];
    const factor = { "+": 0.5, "-": 2 }[event.key];
    if (to === undefined && !factor) return;
    event.preventDefault();
    if (factor) this.stretch(factor);
    else this.#onTime(to);
  }

  paint() {
    if (!this.#picture || this.#canvas.clientWidth === 0) return;
    const { ctx, width, height } = cleared(this.#still, this.#canvas);
    this.#width = width - left - right;
    const between = 24,
      room = height - top - bottom - between * this.#drawn.length;
    const all = this.#drawn.reduce((sum, { share = 1 }) => sum + share, 0);
    let y = top;
    this.#paintBands(ctx, height);
    for (const panel of this.#drawn) {
      y += between;
      const high = ((panel.share ?? 1) / all) * room;
      this.#paintPanel(ctx, panel, y, high);
      y += high;
    }
    this.#paintAxis(ctx, height - bottom, width);
    this.#paintNow();
  }

  #paintNow() {
    if (!this.#picture || this.#still.width === 0) return;
    const { ctx, height } = cleared(this.#canvas);
    ctx.drawImage(this.#still, 0, 0, this.#canvas.clientWidth, this.#canvas.clientHeight);
    const x = this.#x(this.#time_s);
    ctx.fillStyle = colour("text");
    ctx.fillRect(x - 0.75, top, 1.5, height - top - bottom);
    ctx.beginPath();
    ctx.moveTo(x - 6, top - 9);
    ctx.lineTo(x + 6, top - 9);
    ctx.lineTo(x, top);
    ctx.fill();
  }

  #paintBands(ctx, height) {
    ctx.textAlign = "center";
    bandsOf(this.#picture).forEach(({ name, from_s, until_s }) => {
      const from = Math.max(left, this.#x(from_s)),
        until = Math.min(left + this.#width, this.#x(until_s));
      if (until <= from) return;
      ctx.fillStyle = colour(band_colours[name] ?? name);
      ctx.globalAlpha = 0.25;
      ctx.fillRect(from, 0, until - from, height - bottom);
      ctx.globalAlpha = 1;
      ctx.fillStyle = colour("text");
      if (ctx.measureText(name).width < until - from - 6)
        ctx.fillText(name, (from + until) / 2, 15);
      ctx.fillRect(from, 0, 0.5, height - bottom);
    });
  }

  #paintAxis(ctx, y, width) {
    const loss_s = this.#picture.mass_loss_s,
      [from, until] = this.part;
    ctx.fillStyle = colour("text");
    ctx.textAlign = "center";
    for (const { value, text } of ticks(
      inMilliseconds(from, loss_s),
      inMilliseconds(until, loss_s),
      this.#width / 80,
    )) {
      const x = this.#x(value / 1e3 + loss_s);
      ctx.fillRect(x - 0.5, y, 1, 4);
      ctx.fillText(text, x, y + 16);
    }
    ctx.fillText("time after the loss, ms", left + this.#width / 2, y + 31, width);
  }

  #paintPanel(ctx, panel, y, height) {
    const [from, until] = this.part;
    const curves = this.#runs.flatMap(({ motion: { time_s: times }, summary }, n) => {
      let first = 0,
        last = times.length - 1;
      while (first < last && times[first + 1] < from) ++first;
      while (last > first && times[last - 1] > until) --last;
      return panel.curves.map((curve, i) => ({
        ...curve,
        set: summary.equations,
        times,
        first,
        last,
        values: panel.columns[n][i],
      }));
    });
    let greatest = 0,
      least = 0;
    const meet = (value) => {
      greatest = Math.max(greatest, value);
      least = Math.min(least, value);
    };
    // Of the whole run: a zoom in time does not change the scale.
    for (const { values, first, last } of curves)
      (this.#onTime ? values : values.slice(first, last + 1)).forEach(meet);
    const level = panel.level?.(this.#picture);
    if (level) meet(level.value);
    if (panel.reaches) meet(panel.reaches);
    greatest += 0.06 * (greatest - least) || 1;
    const place = (value) => y + height * (1 - (value - least) / (greatest - least));

    ctx.textAlign = "right";
    ctx.fillStyle = colour("text");
    for (const { value, text } of ticks(least, greatest, height / 34)) {
      ctx.fillText(text, left - 6, place(value) + 4);
      ctx.globalAlpha = 0.15;
      ctx.fillRect(left, place(value), this.#width, 1);
      ctx.globalAlpha = 1;
    }
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, y - 2, this.#width, height + 3);
    ctx.clip();
    ctx.lineJoin = "round";
    for (const { set, dashes, values, times, first, last } of curves.toReversed()) {
      // Tells sets apart in grey.
      ctx.lineWidth = set === this.#picture.summary.equations ? 2.25 : 1.25;
      ctx.strokeStyle = colour(set);
      ctx.setLineDash(dashes ?? []);
      ctx.beginPath();
      let last_x = -Infinity,
        last_y = 0;
      for (let row = first; row <= last; ++row) {
        // points within half a pixel of the last one drawn are left out
        const x = this.#x(times[row]),
          y = place(values[row]);
        if (Math.abs(x - last_x) < 0.5 && Math.abs(y - last_y) < 0.5 && row < last) continue;
        ctx.lineTo((last_x = x), (last_y = y));
      }
      ctx.stroke();
    }
    if (level) {
      ctx.strokeStyle = ctx.fillStyle = colour("text");
      ctx.setLineDash([4, 3]);
      ctx.beginPath();
      ctx.moveTo(left, place(level.value));
      ctx.lineTo(left + this.#width, place(level.value));
      ctx.stroke();
      ctx.textAlign = "left";
      ctx.fillText(level.text, left + 5, place(level.value) + 14);
    }
    if (panel.curves.length > 1)
      // names at the beginnings of curves
      curves.forEach(({ label, set, values, first }, i) => {
        ctx.fillStyle = colour(set);
        ctx.textAlign = "left";
        ctx.fillText(
          label,
          left + 5,
          place(values[first]) + (values[first] > curves[1 - i].values[first] ? 15 : -6),
        );
      });
    ctx.restore();
    ctx.textAlign = "left";
    ctx.fillStyle = colour("text");
    ctx.font = "600 12px system-ui, sans-serif";
    ctx.fillText(`${panel.title}, ${panel.unit}`, left + 4, y - 7);
    ctx.font = "12px system-ui, sans-serif";
  }
}
