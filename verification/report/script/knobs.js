// A slider and a number field for each quantity. They hold the texts of options, and check nothing: the
// engine reports what it refuses.
import { optionOf, textOf } from "./settings.js";

const slider_steps = 400;

/// Calls `onTurn(option, text, insteadOf)` with the text of an option, or null for the paper's value.
export class Knobs {
  #knobs = new Map(); // by their options

  constructor(form, groups, numbers, onTurn) {
    const known = new Map(numbers.map((number) => [number.name, number]));
    known.set("from", { unit: "s", meaning: "start of what is shown" });
    const fieldsets = groups.map(({ group, knobs }) => {
      const fieldset = document.createElement("fieldset");
      fieldset.append(element("legend", group));
      for (const range of knobs) {
        const knob = new Knob({ ...known.get(range.name), ...range }, onTurn);
        this.#knobs.set(optionOf(range.name), knob);
        fieldset.append(knob.row);
      }
      return fieldset;
    });
    form.firstElementChild.after(...fieldsets);
  }

  /// Shows settings, and next to each number the refusal that concerns it.
  show(options, refusal) {
    const replaced = [...this.#knobs.entries()]
      .filter(([option]) => Object.hasOwn(options, option)).map(([, knob]) => knob.insteadOf);
    for (const [option, knob] of this.#knobs) {
      const text = Object.hasOwn(options, option) ? options[option] : null;
      knob.show(text, { replaced: replaced.includes(option), refusal: names(refusal, option) ? refusal : "" });
    }
  }
}

/// Whether a refusal starts with the name of an option or of its key in scenes.
const names = (refusal, option) =>
  [`--${option}`, option.replaceAll("-", "_")].some((name) =>
    refusal.startsWith(`${name}:`) || refusal.startsWith(`${name} =`));

class Knob {
  #quantity;
  #text;
  #slider;
  #reset;
  #refusal;

  constructor(quantity, onTurn) {
    this.#quantity = quantity;
    const { name, symbol, unit, meaning, paper, typed } = quantity;
    const option = optionOf(name);
    this.insteadOf = quantity.instead_of && optionOf(quantity.instead_of); // the option for the same quantity
    const turn = (text) => onTurn(option, text, this.insteadOf);

    this.row = element("div", "", typed ? "knob typed" : "knob");
    const label = element("label", meaning);
    label.htmlFor = option;
    if (symbol) // such as k_t
      label.append(" ", ...symbol.replace("mu", "μ").split(/_(\w+)/).map((part, n) => element(n % 2 ? "sub" : "i", part)));
    this.#text = element("input");
    Object.assign(this.#text, { id: option, type: "text", inputMode: "decimal", autocomplete: "off" });
    this.#text.placeholder = quantity.unstated ?? "";
    this.#text.addEventListener("input", () => turn(this.#text.value.trim() || null));
    this.#refusal = element("p", "", "refusal");
    this.#refusal.id = `${option}-refusal`;
    this.#text.setAttribute("aria-describedby", this.#refusal.id);
    this.#reset = element("button", paper === null ? "remove" : `paper: ${textOf(paper)}`, "reset");
    this.#reset.type = "button";
    this.#reset.title = "back to the paper's value";
    this.#reset.addEventListener("click", () => turn(null));
    this.row.append(label);
    if (!typed) this.row.append(this.#makeSlider(turn));
    this.row.append(this.#text, element("span", unit, "unit"), this.#reset, this.#refusal);
  }

  #makeSlider(turn) {
    const { meaning, paper } = this.#quantity;
    this.#slider = element("input");
    Object.assign(this.#slider, { type: "range", min: 0, max: slider_steps, step: 1 });
    this.#slider.setAttribute("aria-label", meaning);
    this.#slider.addEventListener("input", () => turn(this.#valueAt(Number(this.#slider.value))));
    const track = element("span", "", "track");
    track.append(this.#slider);
    if (paper !== null) {
      const mark = element("span", "", "mark");
      mark.style.setProperty("--at", this.#positionOf(paper) / slider_steps);
      track.append(mark);
    }
    return track;
  }

  /// The value as a text with three digits; exactly the paper's value at its mark.
  #valueAt(position) {
    const { from, to, logarithmic, paper } = this.#quantity;
    if (paper !== null && position === Math.round(this.#positionOf(paper))) return null;
    const share = position / slider_steps;
    const value = logarithmic ? from * (to / from) ** share : from + (to - from) * share;
    return textOf(Number(value.toPrecision(3)));
  }

  #positionOf(value) {
    const { from, to, logarithmic } = this.#quantity;
    const share = logarithmic ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
    return slider_steps * Math.min(1, Math.max(0, share));
  }

  /// `replaced`: another option states this quantity.
  show(text, { replaced, refusal }) {
    const { paper } = this.#quantity;
    const shown = text ?? (paper === null || replaced ? "" : textOf(paper));
    if (document.activeElement !== this.#text) this.#text.value = shown;
    this.#text.setAttribute("aria-invalid", String(refusal !== ""));
    this.#refusal.textContent = refusal;
    this.#reset.hidden = text === null;
    if (!this.#slider) return;
    const value = Number(shown);
    if (shown !== "" && Number.isFinite(value)) this.#slider.value = Math.round(this.#positionOf(value));
    this.#slider.setAttribute("aria-valuetext", `${shown || "not stated"} ${this.#quantity.unit}`);
    this.row.classList.toggle("unstated", shown === "");
  }
}

function element(tag, text = "", className = "") {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}
