// Colours of curves, from the style sheet, which knows light and dark.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

export const onColoursChanged = (act) =>
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", act);
