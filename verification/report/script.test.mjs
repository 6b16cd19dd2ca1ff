// Units, signs and names on the page, for known numbers: `node --test` runs it.
import assert from "node:assert/strict";
import test from "node:test";

import { bandsOf } from "./script/bands.js";
import { panels, stepPanels, ticks } from "./script/curves.js";
import { climaxOf, inMilliseconds, inWords, stateAt, whirlAt } from "./script/motion.js";
import { numbersOf, sentence } from "./script/outcome.js";
import { column, Recorded } from "./script/recorded.js";
import { forceTip } from "./script/rotor.js";
import { addressOf, commandOf, inSet, leftOutOf, setOf, settingsIn } from "./script/settings.js";
import { results } from "./script/words.js";

const summary = {
  outcome: "no_contact",
  touch_downs: 7,
  mass_loss_reached: true,
  first_contact_s: 29.1046,
  rolling_onset_s: 29.1277,
  rolling_onset_speed_Hz: 45.148,
  peak_normal_force_N: 454827,
  peak_time_s: 29.12786,
  peak_displacement_m: 0.0035675,
  whirl_frequency_Hz: -595.61,
  speed_at_mass_loss_Hz: 149.9925,
  critical_speed_Hz: 10.0658,
  final_speed_Hz: 23.035,
  remarks: ["the ring is round"],
  inputs: {
    mass: 5,
    inertia: 0.009,
    eccentricity: 1.5e-4,
    unbalance_factor: 3,
    stator_radius: 0.063,
    rotor_radius: 0.06,
    friction: 0.3,
  },
};

test("numbers are in their units", () => {
  const numbers = new Map(numbersOf(summary));
  assert.equal(numbers.get("outcome"), "no contact");
  for (const [key, text] of Object.entries({
    touch_downs: "7",
    first_contact_s: "29.1046 s",
    rolling_onset_speed_Hz: "45.15 Hz",
    peak_normal_force_N: "454.8 kN",
    peak_displacement_m: "3.567 mm",
    whirl_frequency_Hz: "−595.61 Hz",
    rolling_until_s: "–",
  }))
    assert.equal(numbers.get(results[key]), text);
  const words = sentence(summary);
  for (const part of [
    "7 times",
    "29.1046 s",
    "454.8 kN",
    "29.1277 s, 23.1 ms after",
    "Remark: the ring is round.",
  ])
    assert.ok(words.includes(part), words);
});

test("a state is that between two rows, in milliseconds after the loss", () => {
  const motion = {
    time_s: [1, 2],
    speed_Hz: [100, 90],
    normal_force_N: [0, -8000],
    contact_state: [2, 0],
  };
  assert.equal(
    inWords(stateAt(motion, 1.25), 1.2),
    "50.00\u00a0ms after the loss: rolling, 97.5\u00a0Hz, 2\u00a0kN",
  );
  assert.equal(inMilliseconds(29.099, 29.1).toFixed(3), "-1.000");
});

test("the whirl has the sign of its sense", () => {
  const time_s = Array.from({ length: 101 }, (_, n) => n * 1e-5),
    turn = (t) => -2 * Math.PI * 600 * t; // against the rotation
  const motion = {
    time_s,
    x_a_m: time_s.map((t) => Math.cos(turn(t))),
    y_a_m: time_s.map((t) => Math.sin(turn(t))),
  };
  assert.ok(Math.abs(whirlAt(motion, 5e-4) + 600) < 1);
});

test("curves are in the units of their axes", () => {
  const motion = {
    time_s: [0, 1],
    normal_force_N: [0, -2000],
    speed_Hz: [150, 149],
    x_a_m: [0, 3e-3],
    y_a_m: [0, 4e-3],
  };
  const curves = Object.fromEntries(
    panels.map(({ title, unit, curves: [curve] }) => [
      `${title}, ${unit}`,
      curve.of({ motion }).map((value) => value + 0),
    ]),
  );
  assert.deepEqual(curves, {
    "normal force, kN": [0, 2],
    "speed, Hz": [150, 149],
    "distance of O from the axis, mm": [0, 5],
  });
  const whirling = { summary, motion: { time_s: [], x_a_m: [], y_a_m: [], speed_Hz: [45] } };
  for (let n = 0; n < 40; ++n) {
    // 770 turns a second, against the rotation
    const angle = -2 * Math.PI * 770 * n * 1e-5;
    whirling.motion.time_s.push(n * 1e-5);
    whirling.motion.x_a_m.push(3.5e-3 * Math.cos(angle));
    whirling.motion.y_a_m.push(3.5e-3 * Math.sin(angle));
  }
  const [rim, centre] = stepPanels.velocity.curves.map((curve) => curve.of(whirling));
  assert.ok(
    Math.abs(rim[0] - 2 * Math.PI * 45 * 0.06) < 1e-9 &&
      Math.abs(centre[20] - 2 * Math.PI * 770 * 3.5e-3) < 0.05,
    `${rim[0]}, ${centre[20]}`,
  );
  assert.ok(Math.abs(stepPanels.distance.level(whirling).value - 3) < 1e-9);
});

test("ticks are round, within their range, and no two have the same text", () => {
  for (let n = 0; n < 200; ++n) {
    const length = 10 ** (-4 + n / 20),
      least = Math.sin(n) * 30,
      all = ticks(least, least + length, 6);
    assert.ok(all.length >= 2 && all.length <= 8, `${all.length} ticks`);
    assert.equal(
      new Set(all.map(({ text }) => text)).size,
      all.length,
      all.map(({ text }) => text).join(" "),
    );
    for (const { value, text } of all) {
      assert.ok(value >= least - 1e-6 * length && value <= least + 1.000001 * length);
      assert.ok(Math.abs(Number(text.replace("−", "-")) - value) < 1e-3 * length);
    }
  }
});

test("the force on the rotor points inwards, and along the ring by friction", () => {
  // Contact at the right (y_a): a positive friction acts in the sense of rotation, from down to
  // right, so upwards.
  assert.deepEqual(forceTip([100, 0], [1, 0], -20, 5), [80, -5]);
});

test("a column survives its coding in steps", () => {
  const bytes = new Uint8Array(Uint16Array.from([0, 65535, 13107]).buffer);
  assert.deepEqual([...column([-1, 4, btoa(String.fromCharCode(...bytes))])], [-1, 4, 0]);
  const recorded = new Recorded([{ options: { friction: "0.2" }, motion: {} }]);
  assert.ok(recorded.answer({ friction: "0.200", equations: "corrected" }) && !recorded.answer({}));
});

const rolling = {
  summary,
  from_s: 29.08,
  until_s: 29.15,
  mass_loss_s: 29.1,
  events: [
    ["mass_loss", 29.1],
    ["touch_down", 29.105],
    ["release", 29.1053],
    ["touch_down", 29.114],
    ["release", 29.1143],
    ["touch_down", 29.125],
    ["rolling_onset", 29.1277],
  ].map(([event, time_s]) => ({ event, time_s })),
};

test("flight, impacts, sliding and rolling follow each other without gaps", () => {
  assert.deepEqual(
    bandsOf(rolling).map(({ name, from_s, until_s }) => [name, from_s, until_s]),
    [
      ["flight", 29.08, 29.105],
      ["impacts", 29.105, 29.125],
      ["sliding", 29.125, 29.1277],
      ["rolling", 29.1277, 29.15],
    ],
  );
  const freed = { ...rolling, events: rolling.events.slice(0, 5) };
  assert.deepEqual(
    bandsOf(freed).map(({ name }) => name),
    ["flight", "impacts", "flight"],
  );
  assert.deepEqual(
    bandsOf({ ...rolling, events: [] }).map(({ name }) => name),
    ["flight"],
  );
});

test("a run is shown at its largest force, or where O is farthest out after the loss", () => {
  assert.equal(climaxOf(rolling), summary.peak_time_s);
  const motion = { time_s: [29, 29.1, 29.2, 29.3], x_a_m: [5, 0, 1, 3], y_a_m: [0, 0, 2, 0] };
  assert.equal(
    climaxOf({ ...rolling, motion, events: [], summary: { ...summary, peak_time_s: null } }),
    29.3,
  );
});

test("an address keeps settings, and its command is that of one program", () => {
  const stated = { friction: "0.2", clearance: "1e-3", "ring-offset-x": "-1e-4" };
  assert.deepEqual(settingsIn(addressOf(stated)), stated);
  assert.deepEqual(leftOutOf("#friction=1e999&clearance=1e-3&claims"), ["friction=1e999"]);
  for (const hash of [
    "#friction=0.2&x%3Btouch%20p%3B%23=1",
    "#friction=0.2%3Btouch%20p",
    "#%24(touch p)=&clearance=1`p`",
    "#until=29.2%0Atouch%20p%0A&a%0Ap=1",
    "#friction='&clearance='",
    "#--=%1b[2J&\u202e=1",
  ])
    assert.match(commandOf(settingsIn(hash)), /^build\/rotor run( --[a-zH-]+ [\w.+-]+)* --json$/);
  assert.deepEqual([{}, { equations: "published" }].map(setOf), ["corrected", "published"]);
  assert.deepEqual(inSet({ friction: "0.2", equations: "published" }, "corrected"), {
    friction: "0.2",
  });
});
