// The map of outcomes over speed and friction, with a pin for each of the paper's cases.
import { cleared, colour, onChanged, onDragged } from "./colours.js";
import { ticks } from "./curves.js";
import { lines, outcomes } from "./words.js";

/// Outcomes by the letters of the map's cells.
const letters = Object.fromEntries(Object.keys(outcomes).map((name, n) => [n, name]));
const left = 44,
  right = 13,
  top = 8,
  bottom = 40;

export class OutcomeMap {
  #canvas;
  #maps;
  #lines;
  #set = "published";
  #marker;
  #pins = [];
  #now = null; // speed, Hz, and friction of the run shown

  /// `pins`: { label, speed_Hz, friction, options }; onPick(options) and, where a run can be
  /// computed, onDrag(speed_Hz, friction).
  constructor(canvas, { maps, lines: theory, pins, onPick, onDrag }) {
    this.#canvas = canvas;
    this.#maps = maps;
    this.#lines = theory;
    const holder = canvas.parentElement;
    for (const { label, ...pin } of pins) {
      // Neighbours and the axis are not covered.
      const isBelow = this.#pins.length > 0 && this.#pins.length % 2 === 0;
      const className = `pin${isBelow ? " below" : ""}${pin.speed_Hz < 30 ? " after" : ""}`;
      const ariaLabel = `${label}: ${pin.speed_Hz.toFixed(1)} Hz, friction ${pin.friction}`;
      const button = Object.assign(document.createElement("button"), {
        type: "button",
        className,
        textContent: label,
        ariaLabel,
      });
      button.addEventListener("click", () => onPick(pin.options));
      holder.append(button);
      this.#pins.push({ button, ...pin });
    }
    this.#marker = Object.assign(document.createElement("button"), {
      type: "button",
      className: "marker",
      disabled: !onDrag,
    });
    holder.append(this.#marker);
    if (onDrag) this.#letDrag(onDrag);
    onChanged(canvas, () => this.paint());
  }

  show({ set, speed_Hz, friction }) {
    this.#set = set;
    this.#now = { speed_Hz, friction };
    this.paint();
  }

  /// Fills a list with the outcomes in the maps, and the lines.
  showKey(list) {
    const cells = Object.values(this.#maps)
      .flatMap((of) => of.cells)
      .join("");
    list.innerHTML = Object.entries(letters)
      .filter(([letter]) => cells.includes(letter))
      .map(
        ([, name]) =>
          `<li><i style="background: var(--${name})"></i>` +
          `${name.replace("_", " ")}: ${outcomes[name]}</li>`,
      )
      .concat(
        lines
          .filter((of, n) => this.#lines.some(({ line }) => line === n))
          .map(
            ({ width, dashes, words }) =>
              `<li><svg viewBox="0 0 34 4"><path d="M0,2H34" stroke-width="${width}" ` +
              `stroke-dasharray="${dashes}"/></svg>${words}</li>`,
          ),
      )
      .join("");
  }

  #letDrag(onDrag) {
    const within = (value, [least, greatest]) => Math.min(greatest, Math.max(least, value));
    const to = (speed_Hz, friction) =>
      onDrag(within(speed_Hz, [11, 149.9]), within(friction, [0, 0.5]));
    const pick = (event) => {
      const box = this.#canvas.getBoundingClientRect();
      to(...this.#valuesAt(event.clientX - box.left, event.clientY - box.top));
    };
    onDragged(this.#canvas, pick);
    onDragged(this.#marker, (event) => event.type === "pointermove" && pick(event));
    this.#marker.addEventListener("keydown", (event) => {
      const [df, dmu] =
        { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 0.01], ArrowDown: [0, -0.01] }[
          event.key
        ] ?? [];
      if (df === undefined) return;
      event.preventDefault();
      to(this.#now.speed_Hz + df, this.#now.friction + dmu);
    });
  }

  get #box() {
    const { from, to } = this.#maps[this.#set];
    return {
      from,
      to,
      width: this.#canvas.clientWidth - left - right,
      height: this.#canvas.clientHeight - top - bottom,
    };
  }
  #place([speed_Hz, friction]) {
    const { from, to, width, height } = this.#box;
    return [
      left + (width * (speed_Hz - from[0])) / (to[0] - from[0]),
      top + height * (1 - (friction - from[1]) / (to[1] - from[1])),
    ];
  }
  #valuesAt(x, y) {
    const { from, to, width, height } = this.#box;
    return [
      from[0] + ((x - left) / width) * (to[0] - from[0]),
      from[1] + (1 - (y - top) / height) * (to[1] - from[1]),
    ];
  }

  paint() {
    if (!this.#now || this.#canvas.clientWidth === 0) return;
    const { ctx, height } = cleared(this.#canvas),
      box = this.#box;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, box.width, box.height);
    ctx.clip();
    this.#paintCells(ctx, box);
    ctx.strokeStyle = colour("quiet");
    ctx.stroke(); // the frame
    this.#paintLines(ctx);
    ctx.restore();
    ctx.fillStyle = colour("text");
    ctx.textAlign = "center";
    for (const { value, text } of ticks(box.from[0], box.to[0], box.width / 70))
      ctx.fillText(text, this.#place([value, 0])[0], height - 24);
    ctx.fillText("speed at the mass loss, Hz", left + box.width / 2, height - 7);
    ctx.textAlign = "right";
    for (const { value, text } of ticks(box.from[1], box.to[1], box.height / 50))
      ctx.fillText(text, left - 5, this.#place([0, value])[1] + 4);
    ctx.save();
    ctx.translate(12, top + box.height / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.textAlign = "center";
    ctx.fillText("friction μ", 0, 0);
    ctx.restore();
    for (const { button, speed_Hz, friction } of this.#pins)
      put(button, this.#place([speed_Hz, friction]));
    put(this.#marker, this.#place([this.#now.speed_Hz, this.#now.friction]));
    this.#marker.setAttribute(
      "aria-label",
      `shown: ${this.#now.speed_Hz.toFixed(1)} Hz, friction ${this.#now.friction}` +
        (this.#marker.disabled ? "" : "; arrow keys move it"),
    );
  }

  /// Each cell is centred on its point, with edges on whole pixels so that it is not blended with
  /// others.
  #paintCells(ctx, { width, height }) {
    const rows = this.#maps[this.#set].cells,
      count = rows[0].length;
    const inks = Object.fromEntries(
      Object.entries(letters).map(([letter, name]) => [letter, colour(name)]),
    );
    const edge = (n, of, length) => Math.round((length * (n - 0.5)) / (of - 1));
    rows.forEach((cells, row) => {
      const y = top + height - edge(row, rows.length, height),
        next = top + height - edge(row + 1, rows.length, height);
      for (let n = 0, end; n < count; n = end) {
        // like neighbours at once
        for (end = n + 1; cells[end] === cells[n];) ++end;
        ctx.fillStyle = inks[cells[n]];
        ctx.fillRect(
          left + edge(n, count, width),
          next,
          edge(end, count, width) - edge(n, count, width),
          y - next,
        );
      }
    });
  }

  /// Where closed forms equal what they are compared with.
  #paintLines(ctx) {
    for (const { line, points } of this.#lines.filter(({ set }) => set === this.#set)) {
      const { width: wide, dashes } = lines[line];
      ctx.beginPath();
      for (const point of points) ctx.lineTo(...this.#place(point));
      for (const [ink, lineWidth, pattern] of [
        ["page", wide + 2, []],
        ["law", wide, dashes],
      ]) {
        // an edge sets it off
        Object.assign(ctx, { strokeStyle: colour(ink), lineWidth });
        ctx.setLineDash(pattern);
        ctx.stroke();
      }
    }
  }
}

const put = (element, [x, y]) => Object.assign(element.style, { left: `${x}px`, top: `${y}px` });
