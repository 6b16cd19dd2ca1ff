// Fingers on a plot: one moves the time, two stretch it. The page still scrolls up and down.

/// `range()` is what an element shows over its width, `show(from, until)` shows another part.
export function letTouch(element, { range, show }) {
  const fingers = new Map(); // where each is, by its pointer
  element.style.touchAction = "pan-y";

  const share = (event) => {
    const box = element.getBoundingClientRect();
    return (event.clientX - box.left) / box.width;
  };
  const release = (event) => fingers.delete(event.pointerId);

  element.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") return;
    fingers.set(event.pointerId, share(event));
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId)) return;
    const before = [...fingers.values()];
    fingers.set(event.pointerId, share(event));
    const after = [...fingers.values()];
    const [from, until] = range();
    const at = (part) => from + part * (until - from);
    if (after.length === 1) {
      const moved = at(before[0]) - at(after[0]);
      show(from + moved, until + moved);
    } else if (after.length === 2 && Math.abs(after[1] - after[0]) > 0.02) {
      const scale = (before[1] - before[0]) / (after[1] - after[0]);
      const left = at(before[0]) - after[0] * scale * (until - from);
      show(left, left + scale * (until - from));
    }
  });
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
}
