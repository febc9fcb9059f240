// What happens while a picture is shown: the mouse, clicks, a wish to pause, and for how long the page was
// not before the participant's eyes.

import {clockStep_ms} from './browser_facts.js';

let moves = [];
let clicks = [];
let pauseAsked = false;
let away = false;
let absences = [];

/** Where an event was, in pixels of the picture. */
const place = (event) => [event.clientX * devicePixelRatio, event.clientY * devicePixelRatio];

/** Begins to note what happens; `finished()`: whether the page may be left. */
export function listen(finished) {
  addEventListener('pointermove', (event) => {
    away = false;
    for (const each of event.getCoalescedEvents?.() ?? [event]) {
      moves.push([each.timeStamp, ...place(each)]);
    }
  });
  document.documentElement.addEventListener('pointerleave', () => { away = true; });
  addEventListener('pointerdown', (event) => clicks.push(['mouse', event.timeStamp, clockStep_ms()]));
  addEventListener('keydown', (event) => {
    if (event.repeat) return;
    if (event.key === ' ') clicks.push(['key', event.timeStamp, clockStep_ms()]);
    if (event.key === 'Escape') pauseAsked = true;
  });
  addEventListener('visibilitychange', () => { pauseAsked ||= document.hidden; });
  addEventListener('fullscreenchange', () => { pauseAsked ||= !document.fullscreenElement; });
  noteAbsences('page hidden', () => document.hidden, ['visibilitychange']);
  noteAbsences('page without focus', () => !document.hasFocus(), ['focus', 'blur']);
  if (document.fullscreenElement) {
    noteAbsences('page not over the whole screen', () => !document.fullscreenElement, ['fullscreenchange']);
  }
  addEventListener('beforeunload', (event) => { if (!finished()) event.preventDefault(); });
}

/** Whenever the page is not before the participant's eyes or under their hands: for how long. */
function noteAbsences(kind, isAbsent, events) {
  let since = null;
  for (const event of events) {
    addEventListener(event, () => {
      if (isAbsent()) {
        since ??= performance.now();
      } else if (since !== null) {
        absences.push([kind, `for ${((performance.now() - since) / 1000).toFixed(1)} s`]);
        since = null;
      }
    });
  }
}

/** What was pressed on a page was for it alone. */
export function forgetClicks() {
  clicks = [];
  pauseAsked = false;
}

/** All of it since the last call. */
export function takeEvents() {
  const events = {moves, clicks, away, absences, pause: pauseAsked};
  absences = [];
  moves = [];
  clicks = [];
  pauseAsked = false;
  return events;
}
