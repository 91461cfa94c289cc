import './style.css';
import { makeEngine } from './engine/make_worker';
import { App } from './ui/app';

function chooseTheme(): void {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  let chosen: string | null = null;
  try {
    chosen = localStorage.getItem('waywright-theme');
  } catch {
    // Storage is not available.
  }
  document.documentElement.dataset['theme'] = chosen ?? (dark.matches ? 'dark' : 'light');
}

/** Keeps the files of the page for later visits without a network, where the browser allows it. */
function keepForOffline(): void {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  navigator.serviceWorker.register('./sw.js').catch(() => {
    // The page works without it, but only with a network.
  });
}

chooseTheme();
const canvas = document.querySelector<HTMLCanvasElement>('#canvas')!;
const app = new App(document.querySelector<HTMLElement>('#app')!, canvas, makeEngine());
// For tests, and for people who look inside with the browser's console.
Object.assign(window, { waywright: app });
void app.begin().then(() => document.documentElement.setAttribute('data-ready', ''));
keepForOffline();
