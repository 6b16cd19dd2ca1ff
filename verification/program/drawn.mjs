// What the page with knobs draws and writes, held against what the program writes of the same run.
import { execFileSync } from "node:child_process";

/// To be called before the page is there: notes what its canvases are given, by their names.
export const noteDrawing = (page) => page.addInitScript(() => {
  window.drawn = {};
  const of = (context) => (window.drawn[context.canvas.id] ??= { lines: [], texts: [] });
  const { lineTo, fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.lineTo = function (x, y) {
    of(this).lines.push([x, y]);
    return lineTo.call(this, x, y);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    of(this).texts.push(text);
    return fillText.call(this, text, ...place);
  };
});

/// The columns of the trace of a run, by their names.
function traceOf(rotor, options, from_s) {
  const text = execFileSync(rotor, ["run", ...options, "--from", String(from_s), "--trace", "-"],
    { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 });
  const [head, ...rows] = text.split("\n").filter((line) => line && !line.startsWith("#"))
    .map((line) => line.split(","));
  return Object.fromEntries(head.map((name, i) => [name, rows.map((row) => Number(row[i]))]));
}

const least = (column) => column.reduce((one, other) => Math.min(one, other));
const greatest = (column) => column.reduce((one, other) => Math.max(one, other));

/// `set(options)` shows a setting, `summary()` is what the page has of it then.
export async function checkDrawing({ page, rotor, set, summary, expect }) {
  // Contacts, rolling and the time before the mass loss, none of which hangs on the last digits.
  const options = { friction: "0.2", until: "29.2" };
  const stated = Object.entries(options).flatMap(([name, value]) => [`--${name}`, value]);
  await set(options);
  await page.waitForTimeout(300);
  const about = (value, expected, scale, what) =>
    expect(Math.abs(value - expected) <= 1e-3 * scale, `${what} is ${value}, not ${expected}`);

  // The curves' ranges, as those are told who do not see them.
  const told = async (id) => {
    const words = await page.textContent(`#${id} .unseen`);
    const [, from_s] = words.match(/^Between (\S+) and/);
    return { from_s: Number(from_s), range: (label) => {
      const found = words.match(new RegExp(`(?:: |, )${label} from (\\S+) to (\\S+) (\\w+)`));
      expect(found, `${id}: there is no ${label}: ${words}`);
      return found ? [Number(found[1]), Number(found[2]), found[3]] : [NaN, NaN, ""];
    } };
  };
  const { from_s } = await told("force");
  const trace = traceOf(rotor, stated, from_s);
  for (const [id, label, column, factor, unit] of [
    ["force", "F_n", "normal_force_N", 1e-3, "kN"], ["speed", "f", "speed_Hz", 1, "Hz"],
    ["displacement", "rho", "rho_m", 1e3, "mm"], ["displacement", "q1", "q1_m", 1e3, "mm"],
    ["energy", "kinetic", "kinetic_energy_J", 1, "J"], ["energy", "in the ring", "contact_energy_J", 1, "J"],
    ["energy", "in the supports", "support_energy_J", 1, "J"]]) {
    const [from, to, its] = (await told(id)).range(label);
    const column_of = trace[column].map((value) => factor * value), size = greatest(column_of) - least(column_of);
    expect(its === unit, `${label} is in ${its}, not ${unit}`);
    about(from, least(column_of), size, `the least ${label}`);
    about(to, greatest(column_of), size, `the greatest ${label}`);
  }

  // What was lost in the end: the balance of the energies.
  const seen = await summary();
  const { until_end } = seen.energy_J;
  const energy = await told("energy");
  for (const [label, cause] of [["to friction", "friction"], ["to the ring's damper", "contact_damping"],
    ["to the supports' dampers", "support_damping"]]) {
    const [from, to] = energy.range(label);
    about(from, 0, until_end.initial, `the least ${label}`);
    about(to, -until_end[cause], until_end.initial, `the greatest ${label}`);
  }

  // The orbit: x_a down, y_a to the right, the clearance fitting in.
  const drawnOrbit = async () => {
    await page.evaluate(() => {
      window.drawn.orbit = { lines: [], texts: [] };
      document.getElementById("frame").dispatchEvent(new Event("change"));
    });
    await page.waitForTimeout(300);
    return page.evaluate(() => ({ ...window.drawn.orbit, width: document.getElementById("orbit").clientWidth,
      height: document.getElementById("orbit").clientHeight }));
  };
  const orbit = await drawnOrbit();
  expect(orbit.texts.includes("y_a →") && orbit.texts.includes("x_a ↓"), `the orbit's axes are ${orbit.texts}`);
  const { inputs } = seen;
  const pixels = orbit.width / 2 / (1.25 * (inputs.stator_radius - inputs.rotor_radius));
  const curve = orbit.lines.slice(0, -1); // and the bar that tells the scale
  for (const [i, column, middle] of [[0, "y_a_m", orbit.width / 2], [1, "x_a_m", orbit.height / 2]]) {
    const places = curve.map((point) => (point[i] - middle) / pixels);
    about(least(places), least(trace[column]), 3e-3, `the orbit's least ${column}`);
    about(greatest(places), greatest(trace[column]), 3e-3, `the orbit's greatest ${column}`);
  }

  // The rotor: the line from its middle points to its mass centre.
  await page.evaluate(() => {
    window.drawn.rotor = { lines: [], texts: [] };
    document.getElementById("slowness").dispatchEvent(new Event("change"));
  });
  await page.waitForTimeout(300);
  const [time_s] = (await page.textContent("#rotor-state")).match(/[\d.]+(?= s)/).map(Number);
  const row = trace.time_s.findIndex((at) => at >= time_s - 1e-5);
  const size = await page.evaluate(() => document.getElementById("rotor").clientWidth);
  const lines = await page.evaluate(() => window.drawn.rotor.lines);
  const gap = inputs.stator_radius - inputs.rotor_radius, ring = 0.44 * size, width = 0.16;
  const centre = [trace.y_a_m[row], trace.x_a_m[row]].map((place) => (place * ring * width) / gap);
  const length = 0.8 * ring * (1 - width), angle = Math.PI / 2 - trace.q3_rad[row]; // from x_a to y_a
  const tip = [centre[0] + length * Math.cos(angle), centre[1] + length * Math.sin(angle)];
  const off = least(lines.map(([x, y]) => Math.hypot(x - tip[0], y - tip[1])));
  expect(off < 0.05 * length, `the mass centre is drawn ${off} pixels away from where it is`);

  // The numbers, in the same words as the program's.
  const rows = Object.fromEntries(await page.$$eval("#numbers tr", (all) =>
    all.map((one) => [one.querySelector("th").textContent, one.querySelector("td").textContent])));
  const expected = {
    outcome: seen.outcome, "touch-downs": String(seen.touch_downs),
    "first contact": `${seen.first_contact_s.toFixed(4)} s`, "onset of rolling": `${seen.rolling_onset_s.toFixed(4)} s`,
    "speed then": `${seen.rolling_onset_speed_Hz.toFixed(2)} Hz`,
    "largest |F_n|": `${(seen.peak_normal_force_N / 1e3).toFixed(1)} kN`, when: `${seen.peak_time_s.toFixed(4)} s`,
    "largest displacement": `${(seen.max_displacement_m * 1e3).toFixed(3)} mm`,
    "whirl in rolling": `${seen.whirl_frequency_Hz.toFixed(1)} Hz`,
    "speed at the loss": `${seen.speed_at_mass_loss_Hz.toFixed(2)} Hz`,
    "speed at the end": `${seen.final_speed_Hz.toFixed(2)} Hz`,
  };
  for (const name of new Set([...Object.keys(rows), ...Object.keys(expected)]))
    expect(rows[name] === expected[name], `${name} is "${rows[name]}" on the page, not "${expected[name]}"`);
}
