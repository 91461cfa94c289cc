// Helpers that make elements.

type Child = Node | string | null;
type Properties = Record<string, unknown>;

/** Makes an element. A property that starts with `on` is a listener; one with `-`, or `role`, is an attribute. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag, properties: Properties = {}, ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value as EventListener);
    else if (name.includes('-') || name === 'role' || name === 'for') element.setAttribute(name, String(value));
    else Object.assign(element, { [name]: value });
  }
  element.append(...children.filter((child): child is Node | string => child !== null));
  return element;
}

const ICONS: Readonly<Record<string, string>> = {
  select: 'M6 3l12 9-6 1-3 6z',
  pan: 'M12 3v18M3 12h18M12 3l-3 3m3-3 3 3m-3 15-3-3m3 3 3-3M3 12l3-3m-3 3 3 3m15-3-3-3m3 3-3 3',
  point: 'M12 12m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0',
  wall: 'M5 19 19 5',
  chain: 'M4 17 9 7l6 9 5-10',
  polygon: 'M12 3l9 7-3.5 10h-11L3 10z',
  box: 'M5 6h14v12H5z',
  paint: 'M4 20c4 0 5-2 5-4l9-12 2 2-11 10c-1 3-3 4-5 4z',
  erase: 'M8 20h12M5 14l8-9 6 5-8 9H8z',
  undo: 'M9 7 4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2',
  redo: 'M15 7l5 5-5 5M20 12H10a5 5 0 0 0 0 10h2',
  theme: 'M12 4v2m0 12v2m8-8h-2M6 12H4m12 0a4 4 0 1 1-8 0a4 4 0 0 1 8 0m1.7-5.7-1.4 1.4M7.7 16.3l-1.4 1.4m0-11.4 1.4 1.4m8.6 8.6 1.4 1.4',
  brand: 'M3 19 9 7l6 8 6-11',
  close: 'M6 6l12 12M18 6 6 18',
  snap: 'M4 9h16M4 15h16M9 4v16M15 4v16',
};

export function icon(name: string, size = 20): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  for (const [key, value] of Object.entries({
    viewBox: '0 0 24 24', width: size, height: size, fill: 'none', stroke: 'currentColor', 'stroke-width': 1.8,
    'stroke-linecap': 'round', 'stroke-linejoin': 'round', 'aria-hidden': 'true',
  })) svg.setAttribute(key, String(value));
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', ICONS[name]!);
  svg.append(path);
  return svg;
}

export function check(label: string, isOn: boolean, change: (isOn: boolean) => void): HTMLLabelElement {
  const input = h('input', { type: 'checkbox', checked: isOn });
  input.addEventListener('change', () => change(input.checked));
  return h('label', { className: 'check' }, input, label);
}

/** A length in at most six digits. */
export function short(value: number): string {
  if (!Number.isFinite(value)) return '∞';
  return Math.abs(value) >= 1e6 || (Math.abs(value) < 1e-3 && value !== 0) ? value.toExponential(3) : String(Number(value.toPrecision(6)));
}

export function milliseconds(value: number): string {
  if (value <= 0) return 'under 0.1 ms';
  if (value < 0.0995) return `${(value * 1000).toFixed(value < 0.01 ? 1 : 0)} µs`;
  return `${value.toFixed(value < 10 ? 2 : 0)} ms`;
}

export function bytes(value: number): string {
  return value < 1e6 ? `${(value / 1e3).toFixed(0)} kB` : `${(value / 1e6).toFixed(1)} MB`;
}

export const count = (value: number): string => value.toLocaleString('en');

/** Calls a function at most once in a frame. */
export function oncePerFrame(run: () => void): () => void {
  let isWaiting = false;
  return () => {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => {
      isWaiting = false;
      run();
    });
  };
}
