// What a page can find out about the browser it is in, and what no study can do with.

import {text} from './words.js';

const kCoarsestClock_ms = 1;
const kLeastWindow = [640, 480];

/** The step of the page's clock: what stamps of events can tell apart at best. */
function measureClock() {
  let step = Infinity;
  for (let i = 0; i < 20; ++i) {
    const from = performance.now();
    let to = from;
    while (to === from) to = performance.now();
    step = Math.min(step, to - from);
  }
  return step;
}

let clock_ms = null;

/** The same, measured once. */
export const clockStep_ms = () => clock_ms ??= measureClock();

/** The graphics card, or what draws in place of one. */
export function rendererName() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'none';
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

// A program that fills a vector and counts its bits: without vectors there is no engine.
const kOfVectors = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0,
  253, 15, 253, 98, 11);

/** Throws, in words, where the study cannot be shown as it should be. */
export function requireUsable(site) {
  if (matchMedia('(pointer: coarse) and (hover: none)').matches && !site.phones) {
    throw new Error(text('page_needs_keyboard'));
  }
  if (clockStep_ms() > 1.05 * kCoarsestClock_ms) {
    throw new Error(text('page_coarse_clock', {step: clockStep_ms().toFixed(1)}));
  }
  if (!WebAssembly.validate(kOfVectors)) throw new Error(text('page_too_old'));
  if (rendererName() === 'none') throw new Error(text('page_no_webgl'));
}

/** Throws, in words, where the window is smaller than what is to be shown in it. */
export function requireLargeEnough() {
  if (innerWidth < kLeastWindow[0] || innerHeight < kLeastWindow[1]) {
    throw new Error(text('page_too_small',
      {least: kLeastWindow.join(' × '), size: `${innerWidth} × ${innerHeight}`}));
  }
}
