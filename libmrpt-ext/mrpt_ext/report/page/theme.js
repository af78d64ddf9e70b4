// Colours come from the style sheet, so that page, charts and map agree in light and dark.

const known = new Map();

/** Value of the custom property --name. */
export function colour(name) {
  if (!known.has(name)) {
    const style = getComputedStyle(document.documentElement);
    known.set(name, style.getPropertyValue('--' + name).trim() || style.color);
  }
  return known.get(name);
}

/** Calls `redraw` when the reader changes between light and dark. */
export function onThemeChange(redraw) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    known.clear();
    redraw();
  });
}
