// What happens over time: force, speed, energy, displacement. They share their cursor and their
// part of the time, which others can follow.
import uPlot from "uplot";

import { colour } from "./colours.js";
import { plots } from "./curves.js";
import { nameOfEvent } from "./outcome.js";
import { letTouch } from "./touch.js";

const height = 210;

export class Plots {
  #plots = [];
  #picture = null;
  #others = []; // pictures that are drawn behind: { picture, colour, later_s }
  #onPartShown;
  #sharing = false;

  constructor(container, onPartShown) {
    this.#onPartShown = onPartShown;
    for (const spec of plots) {
      const figure = document.createElement("figure");
      figure.id = spec.id;
      figure.className = "plot";
      const caption = document.createElement("figcaption");
      caption.textContent = `${spec.title}, ${spec.unit}`;
      const told = document.createElement("p"); // for those who do not see the curves
      told.className = "unseen";
      figure.append(caption, told);
      container.append(figure);
      this.#plots.push({ spec, figure, told, plot: null, ghosts: [], now: null });
    }
    new ResizeObserver(() => this.#resize()).observe(container);
  }

  /// Draws a picture. `kept`: the part of the time that is shown stays.
  show(picture, kept) {
    this.#picture = picture;
    const part = this.part;
    for (const entry of this.#plots) {
      const data = [picture.motion.time_s, ...entry.spec.curves.map((curve) => curve.of(picture))];
      entry.told.textContent = inWords(entry.spec, data);
      if (!entry.plot) this.#make(entry, data);
      else entry.plot.setData(data, !kept);
    }
    if (kept) this.showPart(...part);
  }

  /// Puts other pictures behind, in the plots whose columns they have.
  showBehind(others) {
    if (others.length === 0 && this.#others.length === 0) return;
    this.#others = others;
    for (const entry of this.#plots)
      entry.ghosts = others.flatMap(({ picture, colour: name, later_s }) =>
        entry.spec.curves.slice(0, 1).filter((curve) => canDraw(curve, picture)).map((curve) => ({
          times: picture.motion.time_s, values: curve.of(picture), name, later_s })));
    if (this.part[0] !== null) this.showPart(...this.part); // with room for them
  }

  /// Shows a part of the time, or all of it.
  showPart(from_s, until_s) {
    for (const { plot } of this.#plots) plot?.setScale("x", { min: from_s, max: until_s });
  }

  get part() {
    const { min, max } = this.#plots[0].plot?.scales.x ?? { min: null, max: null };
    return [min, max];
  }

  /// Marks an instant.
  markNow(time_s) {
    for (const { plot, now } of this.#plots) {
      if (!plot) continue;
      const at = plot.valToPos(time_s, "x");
      now.style.transform = `translateX(${at}px)`;
      now.hidden = !(at >= 0 && at <= plot.over.clientWidth);
    }
  }

  recolour() {
    for (const entry of this.#plots) {
      entry.plot?.destroy();
      entry.plot = null;
    }
    if (this.#picture) this.show(this.#picture, false);
    this.showBehind(this.#others);
  }

  #make(entry, data) {
    const { spec, figure } = entry;
    const axis = { stroke: colour("text"), grid: { stroke: colour("grid"), width: 1 }, ticks: { stroke: colour("grid") } };
    const plot = new uPlot({
      width: figure.clientWidth,
      height,
      legend: { live: true },
      cursor: { sync: { key: "time" }, drag: { x: true, y: false }, points: { size: 5 } },
      scales: { x: { time: false }, y: { range: (u, least, greatest) => rangeWith(entry, u, least, greatest) } },
      axes: [{ ...axis, label: "t, s", labelSize: 18, size: 34 }, { ...axis, size: 62 }],
      series: [
        { label: "t, s", value: (u, value) => value?.toFixed(5) ?? "–" },
        ...spec.curves.map(({ label, colour: name }) => ({
          label, stroke: colour(name), width: 1.25, points: { show: false },
          value: (u, value) => (value === null || value === undefined ? "–" : `${value.toPrecision(5)} ${spec.unit}`),
        })),
      ],
      hooks: {
        drawClear: [(u) => drawGhosts(u, entry.ghosts)],
        draw: spec.events ? [(u) => drawEvents(u, this.#picture.events)] : [],
        setScale: [(u, key) => key === "x" && this.#share(u)],
      },
    }, data, figure);
    entry.plot = plot;
    entry.now = document.createElement("div");
    entry.now.className = "now";
    plot.over.append(entry.now);
    letTouch(plot.over, {
      range: () => [plot.scales.x.min, plot.scales.x.max],
      show: (from_s, until_s) => this.showPart(from_s, until_s),
    });
  }

  /// The part of the time that one plot shows is shown by all.
  #share(from) {
    if (this.#sharing) return;
    this.#sharing = true;
    const { min, max } = from.scales.x;
    for (const { plot } of this.#plots)
      if (plot && plot !== from && (plot.scales.x.min !== min || plot.scales.x.max !== max))
        plot.setScale("x", { min, max });
    this.#sharing = false;
    this.#onPartShown(min, max);
  }

  #resize() {
    for (const { plot, figure } of this.#plots)
      if (plot && plot.width !== figure.clientWidth) plot.setSize({ width: figure.clientWidth, height });
  }
}

/// The ranges of the curves.
function inWords({ curves, unit }, [times, ...columns]) {
  const range = (column) => {
    let least = Infinity, greatest = -Infinity;
    for (const value of column) {
      least = Math.min(least, value);
      greatest = Math.max(greatest, value);
    }
    return `from ${least.toPrecision(4)} to ${greatest.toPrecision(4)} ${unit}`;
  };
  const ranges = columns.map((column, i) => `${curves[i].label} ${range(column)}`);
  return `Between ${times[0].toFixed(3)} and ${times.at(-1).toFixed(3)} s: ${ranges.join(", ")}.`;
}

function canDraw(curve, { motion }) {
  if (curve.label === "F_n") return "normal_force_N" in motion;
  return curve.label === "f" ? "speed_Hz" in motion : "q1_m" in motion;
}

/// Room for what is drawn behind, too.
function rangeWith({ ghosts }, u, least, greatest) {
  const [first, last] = u.series[0].idxs; // of the part that is shown
  const min = u.data[0][first], max = u.data[0][last];
  for (const { times, values, later_s } of ghosts)
    for (let i = 0; i < times.length; ++i)
      if (times[i] - later_s >= min && times[i] - later_s <= max) {
        least = Math.min(least, values[i]);
        greatest = Math.max(greatest, values[i]);
      }
  return uPlot.rangeNum(least, greatest, 0.08, true);
}

function drawGhosts(u, ghosts) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.lineWidth = devicePixelRatio;
  for (const { times, values, name, later_s } of ghosts) {
    ctx.strokeStyle = colour(name);
    ctx.beginPath();
    for (let i = 0; i < times.length; ++i)
      ctx.lineTo(u.valToPos(times[i] - later_s, "x", true), u.valToPos(values[i], "y", true));
    ctx.stroke();
  }
  ctx.restore();
}

/// Those that there is but one of are named, each in a line of its own.
const lines = { mass_loss: 0, rolling_onset: 1, motor_off: 2 };

function drawEvents(u, events) {
  const { ctx, bbox } = u, pixel = devicePixelRatio;
  const told = new Set();
  ctx.save();
  ctx.font = `${11 * pixel}px system-ui, sans-serif`;
  ctx.fillStyle = ctx.strokeStyle = colour("event");
  ctx.lineWidth = pixel;
  for (const { event, time_s } of events) {
    const x = u.valToPos(time_s, "x", true);
    const is_named = event in lines;
    if (x < bbox.left || x > bbox.left + bbox.width || !(is_named || event === "touch_down")) continue;
    ctx.setLineDash(is_named ? [3 * pixel, 3 * pixel] : []);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + (is_named ? bbox.height : 10 * pixel));
    ctx.stroke();
    if (!is_named || told.has(event)) continue;
    told.add(event);
    const at_end = x > bbox.left + 0.7 * bbox.width;
    ctx.textAlign = at_end ? "right" : "left";
    ctx.fillText(nameOfEvent(event), x + (at_end ? -4 : 4) * pixel,
      bbox.top + bbox.height - (6 + 13 * lines[event]) * pixel);
  }
  ctx.restore();
}
