// The participant's screen: filled by the page, its size by a card that is held against it, its distance
// by the eye's blind spot. What is skipped is assumed, and recorded so.
//
//            distance
//     eye ──────────────── ┼  cross              distance = apart / tan(13.5°)
//         ╲ 13.5°          │
//           ╲              │  apart
//             ╲            │
//               ╲───────── ●  the dot, where it disappears
//
// (Li, Joo, Yeatman & Reinecke 2020: the "virtual chinrest"; cards: ISO/IEC 7810, ID-1)

import {$, ask, element, frame, ownPage} from './pages.js';
import {text} from './words.js';

const kCardWidth_m = 0.0856;
const kCardHeight_m = 0.05398;
const kBlindSpot_deg = 13.5;
const kTimes = 5;
const kDotSpeed_m_s = 0.025;
const kNearestDot_m = 0.05;  // the blind spot of an eye that is 20 cm away
const kDeaf_ms = 500;  // to a key that is still on its way up
const kPlausible_m = [0.2, 1.5];
const kAssumed = {height_m: 0.301, distance_m: 0.57};  // as the program assumes them

// ---------------------------------------------------------------- the whole screen

let wanted = false;

/** Leaves the window again for the whole screen, in answer to a key or a click. */
export function restoreFullScreen() {
  if (wanted && !document.fullscreenElement) document.documentElement.requestFullscreen().catch(() => {});
}

async function fillScreen() {
  if (!document.fullscreenEnabled) return;
  const page = ownPage({title: text('page_full_screen'), paragraphs: [text('page_full_screen_why')],
    choices: [{label: text('page_fill_screen'), key: 'space'}],
    answered: () => {
      wanted = true;
      restoreFullScreen();
    }});
  await ask(page);
  const end_ms = performance.now() + 2000;  // some windows slide to their new size
  for (let size = ''; performance.now() < end_ms;) {
    for (let i = 0; i < 20; ++i) await frame();
    const now = `${innerWidth} ${innerHeight}`;
    if (document.fullscreenElement && now === size) break;
    size = now;
  }
  wanted = document.fullscreenElement !== null;
}

// ---------------------------------------------------------------- its size

/** Metres of a CSS pixel; null: skipped. */
async function measurePixel() {
  const card = element('div', {className: 'card'});
  const slider = element('input', {type: 'range', min: 150, max: Math.min(900, innerWidth - 40), value: 324,
    ariaLabel: text('page_card_width')});
  const draw = () => {
    card.style.width = `${slider.value}px`;
    card.style.height = `${slider.value * kCardHeight_m / kCardWidth_m}px`;
  };
  slider.addEventListener('input', draw);
  draw();
  const answer = await ask(ownPage({title: text('page_card'), paragraphs: [text('page_card_how')],
    figure: element('div', {className: 'card-stage'}, slider, card), focus: slider,
    choices: [{label: text('page_card_fits'), key: 'enter'}, {label: text('page_skip'), key: ''}]}));
  return answer.choice === 0 ? kCardWidth_m / Number(slider.value) : null;
}

// ---------------------------------------------------------------- its distance

/** Waits for the space bar or a click, while the dot moves away from the cross; how far it came, in CSS
    pixels. A dot that has reached the edge begins again. */
async function dotGone(dot, cross_px, pixel_m) {
  const begun_ms = performance.now();
  let pressed = false;
  const press = (event) => {
    if (performance.now() - begun_ms < kDeaf_ms) return;
    if (event.type === 'pointerdown' || (event.key === ' ' && !event.repeat)) pressed = true;
  };
  const over = new AbortController();
  addEventListener('keydown', press, {signal: over.signal});
  addEventListener('pointerdown', press, {signal: over.signal});
  let apart_px = kNearestDot_m / pixel_m;
  for (let last_ms = await frame(); !pressed;) {
    dot.style.left = `${cross_px - apart_px}px`;
    const now_ms = await frame();
    apart_px += kDotSpeed_m_s / pixel_m * Math.min(now_ms - last_ms, 50) / 1000;
    if (apart_px > cross_px - 10) apart_px = kNearestDot_m / pixel_m;
    last_ms = now_ms;
  }
  over.abort();
  return apart_px;
}

/** {distance_m, sd_m}; null: skipped, or nothing that can be. */
async function measureDistance(pixel_m) {
  const answer = await ask(ownPage({title: text('page_distance'),
    paragraphs: [text('page_distance_how'), text('page_distance_times', {count: kTimes})],
    choices: [{label: text('continue'), key: 'space'}, {label: text('page_skip'), key: ''}]}));
  if (answer.choice !== 0) return null;
  const dot = element('div', {className: 'dot'});
  const words = element('p', {});
  const cross = element('div', {className: 'cross', textContent: '+'});
  const stage = element('div', {id: 'blind-spot'}, cross, dot, words);
  document.body.append(stage);
  $('page').replaceChildren();
  const distances_m = [];
  for (let number = 1; number <= kTimes; ++number) {
    words.textContent = text('page_distance_gone', {number, total: kTimes});
    const apart_m = pixel_m * await dotGone(dot, 0.85 * innerWidth, pixel_m);
    distances_m.push(apart_m / Math.tan(kBlindSpot_deg * Math.PI / 180));
  }
  stage.remove();
  const mean_m = distances_m.reduce((sum, each) => sum + each) / kTimes;
  const sd_m = Math.sqrt(distances_m.reduce((sum, each) => sum + (each - mean_m) ** 2, 0) / (kTimes - 1));
  return mean_m >= kPlausible_m[0] && mean_m <= kPlausible_m[1] ? {distance_m: mean_m, sd_m} : null;
}

// ---------------------------------------------------------------- all of it

/** {pixel_m, distance}, each null where it was skipped; a page that a participant loads again on the same screen
    does not ask again. */
async function measureOnce() {
  const kPlace = 'impetus screen';
  const participant = new URLSearchParams(location.search).get('participant');
  const present = `${participant} ${screen.width} ${screen.height} ${devicePixelRatio}`;
  const known = JSON.parse(sessionStorage.getItem(kPlace) ?? 'null');
  if (known?.present === present) return known;
  const pixel_m = await measurePixel();
  const distance = pixel_m === null ? null : await measureDistance(pixel_m);
  sessionStorage.setItem(kPlace, JSON.stringify({present, pixel_m, distance}));
  return {pixel_m, distance};
}

/** Fills the screen and measures it as the site asks: {width_m, height_m, viewing_distance_m, measured},
    and `how`, in words. */
export async function measureScreen(site) {
  if (!site.in_window) await fillScreen();
  const {pixel_m, distance} = site.assume_screen ? {pixel_m: null, distance: null} : await measureOnce();
  const used_m = pixel_m ?? kAssumed.height_m / innerHeight;
  return {
    width_m: innerWidth * used_m,
    height_m: innerHeight * used_m,
    viewing_distance_m: distance?.distance_m ?? kAssumed.distance_m,
    measured: pixel_m !== null && distance !== null,
    how: (pixel_m === null ? 'size assumed' : 'size by a bank card') + ', distance ' +
      (distance === null ? 'assumed' : `by the blind spot (${kTimes} times, standard deviation ` +
        `${(100 * distance.sd_m).toFixed(1)} cm)`),
  };
}
