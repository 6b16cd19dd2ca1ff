// Colours and canvases. The style sheet knows light and dark.
export const colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/// Calls act when a canvas has another size, or colours are others.
export function onChanged(canvas, act) {
  new ResizeObserver(act).observe(canvas);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", act);
}

/// An emptied canvas, as large as one is shown: its context in pixels of the page.
export function cleared(canvas, { clientWidth: width, clientHeight: height } = canvas) {
  canvas.width = width * devicePixelRatio;
  canvas.height = height * devicePixelRatio;
  const ctx = canvas.getContext("2d");
  ctx.scale(devicePixelRatio, devicePixelRatio);
  ctx.font = "12px system-ui, sans-serif";
  return { ctx, width, height };
}

/// A line through points, with a filled head at its end.
export function arrow(ctx, points, head = 9) {
  if (points.length < 2) return;
  const [x, y] = points.at(-1),
    [x0, y0] = points.at(-2);
  const angle = Math.atan2(y - y0, x - x0);
  ctx.beginPath();
  for (const point of points) ctx.lineTo(...point);
  ctx.stroke();
  ctx.beginPath();
  for (const turn of [0, 2.5, -2.5])
    ctx.lineTo(x + head * Math.cos(angle + turn), y + head * Math.sin(angle + turn));
  ctx.fill();
}

/// Calls act with the event when an element is pressed, and while it is dragged.
export function onDragged(element, act) {
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    act(event);
  });
  element.addEventListener(
    "pointermove",
    (event) => element.hasPointerCapture(event.pointerId) && act(event),
  );
}
