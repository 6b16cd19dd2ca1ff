// Units, signs and names on the page, for known numbers, and its story for random runs of the program
// $ROTOR: `node --test` runs it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import os from "node:os";
import path from "node:path";
import test from "node:test";

import { panels, stepPanels, ticks } from "./script/curves.js";
import { inMilliseconds, inWords, stateAt, whirlAt } from "./script/motion.js";
import { numbersOf, sentence } from "./script/outcome.js";
import { stacked } from "./script/plots.js";
import { column, Recorded } from "./script/recorded.js";
import { forceTip } from "./script/rotor.js";
import { addressOf, commandOf, inSet, setOf, settingsIn } from "./script/settings.js";
import { bandsOf, storyOf } from "./script/story.js";
import { outcomes, results } from "./script/words.js";

const summary = {
  outcome: "no_contact", touch_downs: 7, mass_loss_reached: true, first_contact_s: 29.1046, rolling_onset_s: 29.1277, rolling_onset_speed_Hz: 45.148,
  peak_normal_force_N: 454827, peak_time_s: 29.12786, max_displacement_m: 0.0035675, whirl_frequency_Hz: -595.61,
  speed_at_mass_loss_Hz: 149.9925, critical_speed_Hz: 10.0658, final_speed_Hz: 23.035, remarks: ["the ring is round"],
  inputs: { mass: 5, inertia: 0.009, eccentricity: 1.5e-4, unbalance_factor: 3, stator_radius: 0.063, rotor_radius: 0.06, friction: 0.3 },
};

test("numbers are in their units", () => {
  const numbers = new Map(numbersOf(summary));
  assert.equal(numbers.get("outcome"), "no contact");
  for (const [key, text] of Object.entries({ touch_downs: "7", first_contact_s: "29.1046 s", rolling_onset_speed_Hz: "45.15 Hz",
    peak_normal_force_N: "454.8 kN", max_displacement_m: "3.567 mm", whirl_frequency_Hz: "-595.61 Hz", rolling_until_s: "–" }))
    assert.equal(numbers.get(results[key]), text);
  const words = sentence(summary);
  for (const part of ["7 times", "29.1046 s", "454.8 kN", "29.1277 s, 23.1 ms after", "Remark: the ring is round."])
    assert.ok(words.includes(part), words);
});

test("a state is that between two rows, in milliseconds after the loss", () => {
  const motion = { time_s: [1, 2], speed_Hz: [100, 90], normal_force_N: [0, -8000], contact_state: [2, 0] };
  assert.equal(inWords(stateAt(motion, 1.25), 1.2), "50.00\u00a0ms after the loss: rolling, 97.5\u00a0Hz, 2\u00a0kN");
  assert.equal(inMilliseconds(29.099, 29.1).toFixed(3), "-1.000");
});

test("the whirl has the sign of its sense", () => {
  const time_s = Array.from({ length: 101 }, (_, n) => n * 1e-5), turn = (t) => -2 * Math.PI * 600 * t; // against the rotation
  const motion = { time_s, x_a_m: time_s.map((t) => Math.cos(turn(t))), y_a_m: time_s.map((t) => Math.sin(turn(t))) };
  assert.ok(Math.abs(whirlAt(motion, 5e-4) + 600) < 1);
});

test("curves are in the units of their axes, losses positive, and areas are stacked", () => {
  const motion = { time_s: [0, 1, 2], normal_force_N: [0, -2000, 0], speed_Hz: [150, 149, 148],
    kinetic_energy_J: [5000, 4000, 3000], contact_energy_J: [0, 1000, 0], support_energy_J: [1000, 2000, 3000] };
  const works = { time_s: [0, 2], friction: [0, -4000], contact_damping: [0, -2000], support_damping: [0, -1000], motor: [0, 6] };
  const curves = Object.fromEntries(panels.flatMap(({ unit, curves: of }) =>
    of.map((curve) => [`${curve.label}, ${unit}`, curve.of({ motion, works }).map((value) => value + 0)])));
  assert.deepEqual(curves, {
    "normal force, kN": [0, 2, 0], "speed, Hz": [150, 149, 148], "motion, kJ": [5, 4, 3], "supports, kJ": [1, 2.5, 4],
    "ring, kJ": [0, 1, 0], "ring's damper, kJ": [0, 1, 2], "lost to friction, kJ": [0, 2, 4],
  });
  const whirling = { summary, motion: { time_s: [], x_a_m: [], y_a_m: [], speed_Hz: [45] } };
  for (let n = 0; n < 40; ++n) { // 770 turns a second, against the rotation
    const angle = -2 * Math.PI * 770 * n * 1e-5;
    whirling.motion.time_s.push(n * 1e-5);
    whirling.motion.x_a_m.push(3.5e-3 * Math.cos(angle));
    whirling.motion.y_a_m.push(3.5e-3 * Math.sin(angle));
  }
  const [rim, centre] = stepPanels.velocity.curves.map((curve) => curve.of(whirling));
  assert.ok(Math.abs(rim[0] - 2 * Math.PI * 45 * 0.06) < 1e-9 && Math.abs(centre[20] - 2 * Math.PI * 770 * 3.5e-3) < 0.05, `${rim[0]}, ${centre[20]}`);
  assert.ok(Math.abs(stepPanels.distance.curves[0].of(whirling)[7] - 3.5) < 1e-9 && Math.abs(stepPanels.distance.level(whirling).value - 3) < 1e-9);
  assert.deepEqual(stacked([[1, 2], [10, 20], [100, 200]]), [[1, 2], [11, 22], [111, 222]]);
});

test("ticks are round, within their range, and no two have the same text", () => {
  for (let n = 0; n < 200; ++n) {
    const length = 10 ** (-4 + n / 20), least = Math.sin(n) * 30, all = ticks(least, least + length, 6);
    assert.ok(all.length >= 2 && all.length <= 8, `${all.length} ticks`);
    assert.equal(new Set(all.map(({ text }) => text)).size, all.length, all.map(({ text }) => text).join(" "));
    for (const { value, text } of all) {
      assert.ok(value >= least - 1e-6 * length && value <= least + 1.000001 * length);
      assert.ok(Math.abs(Number(text.replace("−", "-")) - value) < 1e-3 * length);
    }
  }
});

test("the force on the rotor points inwards, and along the ring by friction", () => {
  // Contact at the right (y_a): a positive friction acts in the sense of rotation, from down to right, so upwards.
  assert.deepEqual(forceTip([100, 0], [1, 0], -20, 5), [80, -5]);
});

test("a column survives its coding in steps", () => {
  const bytes = new Uint8Array(Uint16Array.from([0, 65535, 13107]).buffer);
  assert.deepEqual([...column([-1, 4, btoa(String.fromCharCode(...bytes))])], [-1, 4, 0]);
  const recorded = new Recorded([{ options: { friction: "0.2" } }]);
  assert.ok(recorded.has({ friction: "0.200", equations: "published" }) && !recorded.has({}));
});

const rolling = { summary, from_s: 29.08, until_s: 29.15, mass_loss_s: 29.1, events: [
  ["mass_loss", 29.1], ["touch_down", 29.105], ["release", 29.1053], ["touch_down", 29.114], ["release", 29.1143],
  ["touch_down", 29.125], ["rolling_onset", 29.1277]].map(([event, time_s]) => ({ event, time_s })) };

test("flight, impacts, sliding and rolling follow each other without gaps", () => {
  assert.deepEqual(bandsOf(rolling).map(({ name, from_s, until_s }) => [name, from_s, until_s]),
    [["flight", 29.08, 29.105], ["impacts", 29.105, 29.125], ["sliding", 29.125, 29.1277], ["rolling", 29.1277, 29.15]]);
  const freed = { ...rolling, events: rolling.events.slice(0, 5) };
  assert.deepEqual(bandsOf(freed).map(({ name }) => name), ["flight", "impacts", "flight"]);
  assert.deepEqual(bandsOf({ ...rolling, events: [] }).map(({ name }) => name), ["flight"]);
});

test("the story has six moments in their order, with the run's numbers", () => {
  const story = storyOf(rolling);
  assert.equal(story.length, 6);
  story.slice(1).forEach(({ time_s }, n) => assert.ok(time_s >= story[n].time_s, story[n].title));
  const text = story.map((moment) => moment.title + moment.text).join(" ").replaceAll("\u00a0", " ");
  for (const part of ["150 Hz", "15 times", "0.3 mm", "3 mm", "4.6 ms later", "3 touch-downs", "45.1 Hz", "455 kN", "9300 times"])
    assert.ok(text.includes(part), `${part}: ${text}`);
  const motion = { time_s: [29, 29.1, 29.2, 29.3], x_a_m: [5, 0, 1, 3], y_a_m: [0, 0, 2, 0] };
  const clear = storyOf({ ...rolling, motion, events: [], until_s: 29.3, summary: { ...summary, first_contact_s: null } });
  assert.deepEqual([clear.length, clear.at(-1).time_s], [3, 29.3]); // when it is farthest out after the loss
});

/// A run of the program in the form of the engine's answers, or null for settings that are refused.
function pictureOf(folder, options) {
  const words = Object.entries(options).flatMap(([name, value]) => (value === "" ? [`--${name}`] : [`--${name}`, String(value)]));
  const run = (...more) => execFileSync(path.resolve(process.env.ROTOR ?? "build/rotor"), ["run", "--json", ...words, ...more],
    { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], cwd: folder });
  const tableOf = (name) => {
    const [head, ...rows] = readFileSync(path.join(folder, name), "utf8").trim().split("\n").filter((line) => !line.startsWith("#"))
      .map((line) => line.split(","));
    return rows.map((row) => Object.fromEntries(head.map((column, n) => [column, Number.isNaN(Number(row[n])) ? row[n] : Number(row[n])])));
  };
  try {
    const found = JSON.parse(run("--events", "events.csv", "--trace", "trace.csv", "--columns", "time_s,x_a_m,y_a_m"));
    const motion = tableOf("trace.csv"), from_s = motion[0].time_s;
    return { summary: found, events: tableOf("events.csv"), from_s, until_s: found.final_time_s,
      mass_loss_s: found.speed_at_mass_loss_Hz === null ? null : found.inputs.mass_loss_time,
      motion: Object.fromEntries(["time_s", "x_a_m", "y_a_m"].map((name) => [name, motion.map((row) => row[name])])) };
  } catch (error) {
    if (error.status === 1) return null;
    throw error;
  }
}

test("no story contradicts its run, and its moments are in their order", () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), "rotor-story-"));
  let state = 1; // xorshift32
  const share = () => {
    for (const shift of [13, -17, 5]) state ^= shift > 0 ? state << shift : state >>> -shift;
    return (state >>> 0) / 2 ** 32;
  };
  const between = (least, greatest) => least + (greatest - least) * share();
  const log = (least, greatest) => least * (greatest / least) ** share();
  const one = (...of) => of[Math.floor(of.length * share())];
  const random = () => ({ equations: one("published", "consistent"), "start-speed-hz": between(1, 160), torque: one(0, log(0.05, 10)),
    friction: one(0, between(0, 0.6)), clearance: log(2e-4, 2e-3), "contact-damping": log(1e2, 1e5), eccentricity: log(5e-5, 5e-4),
    "support-stiffness": log(2e3, 2e5), "support-damping": between(0, 200), gravity: one(0, 9.81, 100),
    ...one({ until: log(3e-3, 0.3) }, { until: 0.3 }, { until: 0.3, "mass-loss-time": between(0, 0.4) }, { until: 0.2, "no-mass-loss": "" }),
    ...one({}, { "unbalance-factor": between(1, 6) }, { "unbalance-factor": 1 }) });
  const seen = new Set();
  try {
    for (const options of [{ until: 29.103 }, { clearance: "1.3e-3" }, { clearance: "1.3e-3", "no-mass-loss": "", until: 5 },
      { friction: 0.08 }, ...Array.from({ length: 100 }, random)]) {
      const picture = pictureOf(folder, options);
      if (picture === null) continue;
      const run = picture.summary, story = storyOf(picture), case_ = JSON.stringify([options, story], null, 1);
      const texts = story.map(({ title, text }) => `${title}. ${text}`), all = [...texts, sentence(run)].join("\n").replaceAll("\u00a0", " ");
      story.forEach(({ time_s }, n) => assert.ok(
        time_s >= (story[n - 1]?.time_s ?? picture.from_s) && time_s <= picture.until_s, `moment ${n} of ${case_}`));
      assert.ok(!/NaN|Infinity|undefined|null|[-−][\d.]+ m?s\b/.test(all), case_);
      const says = (...words) => words.some((word) => texts.some((text) => text.includes(word)));
      for (const [outcome, words] of Object.entries(outcomes)) {
        if (outcome !== run.outcome) assert.ok(!says(words), `${outcome}: ${case_}`);
        else if (outcome !== "rolling") assert.ok(says(words), `no ${outcome}: ${case_}`);
      }
      const touches = run.first_contact_s !== null, rolls = run.rolling_onset_s !== null;
      const touches_first = touches && run.first_contact_s < picture.mass_loss_s;
      for (const [words, holds] of [
        ["It stays clear", run.outcome === "no_contact"],
        ["No contact so far", !touches && run.outcome !== "no_contact"],
        ["First impact", touches],
        ["touch-down", touches && (!rolls || run.touch_downs > 1) && says("touch-down")],
        ["Slip ends", rolls],
        ["No rolling", touches && !rolls],
        ["The rotor keeps all of its mass", !run.mass_loss_reached],
        ["A piece leaves the rim", run.mass_loss_reached],
        ["ms later", run.mass_loss_reached && touches && !touches_first],
        ["touches the ring before", run.mass_loss_reached && touches_first],
        ["Friction at the rim", touches && run.inputs.friction > 0],
        ["holds the mass on this circle", rolls && run.peak_time_s >= run.rolling_onset_s],
      ]) assert.equal(says(words), holds, `${words}: ${case_}`);
      const end_s = bandsOf(picture).reduce((before_s, { from_s, until_s }) => {
        assert.ok(from_s === before_s && until_s > from_s, `${JSON.stringify(bandsOf(picture))} of ${case_}`);
        return until_s;
      }, picture.from_s);
      assert.equal(end_s, picture.until_s, case_);
      seen.add(run.outcome);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
  assert.ok(seen.size >= 6, `only ${[...seen].join(", ")}`);
});

test("an address keeps settings, and its command is that of one program", () => {
  for (const end of ["", "/"])
    assert.deepEqual(settingsIn(addressOf({ friction: "0.2", "no-mass-loss": "" }) + end), { friction: "0.2", "no-mass-loss": "" });
  for (const hash of ["#friction=0.2&x%3Btouch%20p%3B%23=1", "#friction=0.2%3Btouch%20p", "#%24(touch p)=&until=1`p`",
    "#until=29.2%0Atouch%20p%0A&a%0Ap=1", "#friction='&until='", "#--=%1b[2J&\u202e=1"])
    assert.match(commandOf(settingsIn(hash)), /^build\/rotor run( --[a-z-]+ [\w.+-]+)* --energy --json$/);
  assert.deepEqual([{}, { equations: "consistent" }, { "velocity-jump": "once" }].map(setOf), ["published", "consistent", null]);
  assert.deepEqual(inSet({ friction: "0.2", "velocity-jump": "once" }, "published"), { friction: "0.2" });
});
