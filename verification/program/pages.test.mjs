// Units, signs and names of what the pages show, for known numbers: `node --test` runs it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

import { plots } from "../../figures/explore/page/curves.js";
import { inWords, stateAt } from "../../figures/explore/page/motion.js";
import { numbersOf, sentence, textsOf } from "../../figures/explore/page/outcome.js";

const summary = {
  outcome: "no_contact", touch_downs: 7, first_contact_s: 29.1046, rolling_onset_s: 29.1277, rolling_onset_speed_Hz: 45.148,
  peak_normal_force_N: 454827, peak_time_s: 29.12786, max_displacement_m: 0.0035675, whirl_frequency_Hz: -595.61,
  speed_at_mass_loss_Hz: 149.9925, final_speed_Hz: 23.035, remarks: ["the ring is round"],
};

test("the explorer shows numbers in their units", () => {
  assert.deepEqual(numbersOf(summary).map(([, text]) => text), ["no contact", "7", "29.1046 s", "29.1277 s", "45.15 Hz",
    "454.8 kN", "29.1279 s", "3.567 mm", "-595.6 Hz", "149.99 Hz", "23.04 Hz"]);
  assert.equal(new Map(numbersOf({ ...summary, whirl_frequency_Hz: null })).get("whirl in rolling"), "–");
  const words = sentence(summary);
  for (const part of ["7 times", "29.1046 s", "454.8 kN", "29.1277 s, 23.1 ms after", "Remark: the ring is round."])
    assert.ok(words.includes(part), words);
});

test("the explorer's events have forces as magnitudes", () => {
  assert.deepEqual(textsOf({ time_s: 29.1, event: "break_away", normal_force_N: -12340, slip_velocity_m_per_s: -1.5 }),
    ["29.1000 s", "break-away", "12.3 kN", "-1.50 m/s"]);
});

test("the explorer's state is that between two rows", () => {
  const motion = { time_s: [1, 2], speed_Hz: [100, 90], normal_force_N: [0, -8000], contact_state: [2, 2] };
  assert.equal(inWords(stateAt(motion, 1.25)), "t = 1.25000 s, rolling, f = 97.5 Hz, F_n = -2 kN");
});

test("the explorer's curves are in the units of their axes, and losses positive", () => {
  const motion = { time_s: [0, 1, 2], normal_force_N: [0, -2000, 0], speed_Hz: [150, 149, 148], rho_m: [1e-3, 2e-3, 3e-3],
    q1_m: [-1e-3, 0, 1e-3], kinetic_energy_J: [5, 4, 3], contact_energy_J: [0, 1, 0], support_energy_J: [1, 2, 3] };
  const works = { time_s: [0, 2], friction: [0, -4], contact_damping: [0, -2], support_damping: [0, -1], motor: [0, 6] };
  const curves = Object.fromEntries(plots.flatMap(({ unit, curves: of }) =>
    of.map((curve) => [`${curve.label}, ${unit}`, curve.of({ motion, works })])));
  assert.deepEqual(curves, {
    "F_n, kN": [0, -2, 0], "f, Hz": [150, 149, 148], "kinetic, J": [5, 4, 3], "in the ring, J": [0, 1, 0],
    "in the supports, J": [1, 2, 3], "to friction, J": [-0, 2, 4], "to the ring's damper, J": [-0, 1, 2],
    "to the supports' dampers, J": [-0, 0.5, 1], "from the motor, J": [0, 3, 6], "rho, mm": [1, 2, 3], "q1, mm": [-1, 0, 1],
  });
});

test("the report's film shows the force on the rotor, its size, time and speed", () => {
  const elements = {};
  const element = () => ({ style: {}, set: {}, setAttribute(name, value) { this.set[name] = value; }, addEventListener() {} });
  const document = { getElementById: (id) => elements[id] ??= element() };
  // At rest, then 1 mm to the right (y_a) with 20 kN inwards and 5 kN of friction.
  const data = { first_angle: 0, ring_mm: 50, rotor_mm: 49, enlarged: 10, per_kN: 0.5, slower: 100,
    frames: [[-1.5, 1, 0, 0, -20, 5, 2, 149.96], [0, 0, 0, 0, 0, 0, 0, 150]] };
  document.getElementById("film-data").textContent = JSON.stringify(data);
  const script = readFileSync(new URL("../report/page.js", import.meta.url), "utf8");
  new Function("document", "matchMedia", script)(document, () => ({ matches: false }));
  const text = (id) => elements[`film-${id}`].textContent;
  assert.deepEqual(["ms", "kN", "Hz", "state"].map(text), ["−1.50 ms", "20 kN", "150.0 Hz", "rolling without slip"]);
  const { x1, y1, x2, y2 } = elements["film-force"].set;
  assert.deepEqual([x1, y1], [100, 0]); // where the rim touches the ring
  assert.deepEqual([x2 - x1, y2 - y1], [-10, -2.5]); // inwards, and along the ring
});
