// The colours of the picture. style.css has them as custom properties, for dark and light.

const NAMES = [
  'page', 'ground', 'mesh', 'solid', 'solid-outline', 'wall', 'point', 'text', 'accent', 'accent-soft', 'second', 'third',
  'start', 'failed', 'gap', 'level-1', 'level-2', 'level-3', 'seen', 'seen-edge', 'unit', 'touched',
] as const;
export type Ink = (typeof NAMES)[number];
export type Theme = Readonly<Record<Ink, string>>;

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])) as Theme;
}
