// Moves the rotor of the accident. Readers who ask for reduced motion keep the stills.
"use strict";
(() => {
  const film = document.getElementById("film");
  if (!film || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const data = JSON.parse(document.getElementById("film-data").textContent);
  const at = (id) => document.getElementById("film-" + id);
  const states = ["free", "sliding along the ring", "rolling without slip", "free, the ring still pressed in"];
  const unit = 100 / data.ring_mm, radius = 100 - data.enlarged * (data.ring_mm - data.rotor_mm) * unit;
  const frames = data.frames, last = frames.length - 1;
  let index = 0, playing = false, begun = 0, from = 0;

  const place = (element, x, y) => { element.setAttribute("cx", x); element.setAttribute("cy", y); };
  function show(n) {
    index = n;
    const [ms, y_a, x_a, angle, normal, friction, state, Hz] = frames[n];
    const x = data.enlarged * unit * y_a, y = data.enlarged * unit * x_a;  // x_a points down
    const q3 = angle + data.first_angle, rho = Math.hypot(x, y) || 1, nx = x / rho, ny = y / rho;
    const kx = x + radius * nx, ky = y + radius * ny;
    at("disk").setAttribute("r", radius);
    place(at("disk"), x, y);
    place(at("centre"), x, y);
    place(at("mark"), x + 0.86 * radius * Math.sin(q3), y + 0.86 * radius * Math.cos(q3));
    place(at("contact"), kx, ky);
    const force = at("force");
    force.setAttribute("x1", kx);
    force.setAttribute("y1", ky);
    force.setAttribute("x2", kx + data.per_kN * (normal * nx + friction * ny));
    force.setAttribute("y2", ky + data.per_kN * (normal * ny - friction * nx));
    force.style.visibility = at("contact").style.visibility = normal < 0 ? "visible" : "hidden";
    at("ms").textContent = ms.toFixed(2).replace("-", "\u2212") + " ms";
    at("state").textContent = states[state];
    at("kN").textContent = Math.abs(normal).toFixed(0) + " kN";
    at("Hz").textContent = Hz.toFixed(1) + " Hz";
    at("time").value = n;
    at("time").setAttribute("aria-valuetext", ms.toFixed(2) + " ms after the loss");
  }
  // Frames stand at equal distances.
  const frame_ms = (frames[last][0] - frames[0][0]) / last * data.slower;
  function step(now) {
    if (!playing) return;
    const next = Math.min(last, from + Math.floor(Math.max(0, now - begun) / frame_ms));
    if (next !== index) show(next);
    if (next === last) return play(false);
    requestAnimationFrame(step);
  }
  function play(on) {
    playing = on;
    at("play").textContent = on ? "Pause" : index === last ? "Again" : "Play";
    if (!on) return;
    if (index === last) show(0);
    from = index;
    begun = performance.now();
    requestAnimationFrame(step);
  }
  at("play").addEventListener("click", () => play(!playing));
  at("time").addEventListener("input", (event) => { play(false); show(Number(event.target.value)); });
  film.hidden = false;
  show(0);
})();
