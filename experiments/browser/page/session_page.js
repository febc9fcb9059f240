// A session in a page from its first page to its last. The session itself is WebAssembly (impetus.wasm),
// the program's own; it waits for what the functions below promise.
//
//   site.json ─> browser usable? ─> full screen, its size and distance ─> run_page() ─> the end

import {clockStep_ms, rendererName, requireLargeEnough, requireUsable} from './browser_facts.js';
import {forgetClicks, listen, takeEvents} from './happenings.js';
import {Keeper} from './keeper.js';
import {$, ask, element, frame, ownPage, showProgress, showTrouble, tell} from './pages.js';
import {measureScreen, restoreFullScreen} from './screen_measure.js';
import {speak, text} from './words.js';

const link = new URLSearchParams(location.search);
let finished = false;

/** What the program asks of the page. */
function asksOf(keeper) {
  return {
    nextFrame: frame,
    ask: async (page) => JSON.stringify(await ask({...JSON.parse(page), answered: restoreFullScreen})),
    awaitSaved: (standing) => keeper.keep(standing).then(() => admitForgetting(keeper),
      (error) => giveUp(error, keeper)),
    handOver: (line) => keeper.add(line),
    takeEvents: () => JSON.stringify(takeEvents()),
    showProgress: (progress) => showProgress(JSON.parse(progress)),
    showTarget: (on, x, y) => {
      $('target').hidden = !on;
      $('target').style.left = `${x / devicePixelRatio}px`;
      $('target').style.top = `${y / devicePixelRatio}px`;
    },
    showPicture: (withPointer) => {
      document.body.className = withPointer ? 'picture' : 'picture no-pointer';
    },
    tell: (sentence) => tell(text('page_cannot_go_on'), [sentence]),
  };
}

/** The picture fills the window as it is when the session begins. */
function layOut() {
  const canvas = $('picture');
  canvas.width = Math.round(innerWidth * devicePixelRatio);
  canvas.height = Math.round(innerHeight * devicePixelRatio);
  canvas.style.width = `${innerWidth}px`;
  canvas.style.height = `${innerHeight}px`;
  canvas.hidden = false;
  return canvas;
}

async function fetched(file, as) {
  const answer = await fetch(file);
  if (!answer.ok) throw new Error(`${file}: the server answered ${answer.status}`);
  return answer[as]();
}

async function prepare() {
  const [site, study] = await Promise.all([fetched('site.json', 'json'), fetched('study.json', 'text')]);
  document.documentElement.lang = site.language;
  const isHebrewOrArabic = /[\u0590-\u08ff]/.test(site.texts.continue);
  document.documentElement.dir = isHebrewOrArabic ? 'rtl' : 'ltr';
  document.title = site.title;
  speak(site.texts);
  requireUsable(site);
  const keeper = new Keeper(site, link,
    (problem) => showTrouble(problem && text('page_not_sent', {why: problem})));
  const standing = await keeper.begin();
  if (keeper.finished) {
    tell(text('page_done_already'), [text('declined_title')], ...await downloadsOf(keeper));
    await end('finished', keeper);
    return null;
  }
  const program = await createImpetus({page: asksOf(keeper)});
  program.FS.writeFile('/study.json', study);
  program.FS.writeFile('/standing.json', JSON.stringify(standing));
  program.FS.mkdir('/trees');
  await Promise.all(site.trees.map(async (tree) => program.FS.writeFile(`/trees/${tree}`,
    new Uint8Array(await fetched(`trees/${tree}`, 'arrayBuffer')))));
  return {site, keeper, program};
}

function writeFacts(program, site, canvas, keeper, screen) {
  program.FS.writeFile('/facts.json', JSON.stringify({
    participant: keeper.code,
    seed: Number(link.get('seed') ?? 1),
    machine: navigator.userAgent,
    display: `page of ${canvas.width} x ${canvas.height} px at a pixel ratio of ${devicePixelRatio}, ` +
      `${document.fullscreenElement ? 'over the whole screen' : 'in a window'}; ${rendererName()}; ` +
      `clock step ${clockStep_ms().toFixed(3)} ms${window.crossOriginIsolated ? ', isolated' : ''}; ` +
      `flip stamp: begin of the frame after the one that was drawn in; ${screen.how}`,
    screen: {width_m: screen.width_m, height_m: screen.height_m, width_px: canvas.width,
      height_px: canvas.height, viewing_distance_m: screen.viewing_distance_m},
    screen_measured: screen.measured,
    allow_failed_sync: site.allow_failed_sync,
  }));
}

function downloadOf([name, lines]) {
  const file = URL.createObjectURL(new Blob([lines], {type: 'application/jsonl'}));
  return element('p', {}, element('a', {href: file, download: name, textContent: name}));
}

/** What is kept in this browser alone, for the participant to hand over. */
async function downloadsOf(keeper) {
  const refused = await keeper.refused();
  return [...(await keeper.files()).map(downloadOf),
    ...(refused.length > 0 ? [element('p', {textContent: text('page_not_taken')})] : []),
    ...refused.map(downloadOf)];
}

/** What was answered will not be taken: nothing more is asked. */
async function giveUp(error, keeper) {
  tell(text('page_cannot_go_on'), [error.message], ...await downloadsOf(keeper));
  await end('failed', keeper);
  return new Promise(() => {});
}

let admitted = false;

/** Says once that a page which is closed begins anew. */
async function admitForgetting(keeper) {
  if (!keeper.forgetful || admitted) return;
  admitted = true;
  await ask(ownPage({paragraphs: [text('page_not_remembered')], choices: [{label: text('continue'), key: 'space'}]}));
  forgetClicks();
}

/** The window of the experiment that this page is a trial of; null: it is a page of its own. */
function experiment() {
  try {
    return parent !== window && parent.location.origin === location.origin ? parent : null;
  } catch {
    return null;
  }
}

/** Says how it ended: to whoever looks at the page, and to the experiment it is part of. */
async function end(ending, keeper) {
  finished = true;
  document.body.dataset.ending = ending;
  const files = keeper && !keeper.site.drop ? await keeper.files() : [];
  experiment()?.postMessage({impetus: {ending, participant: keeper?.code ?? '',
    files: files.map(([name, lines]) => ({name, lines}))}}, location.origin);
}

async function run() {
  const prepared = await prepare();
  if (!prepared) return;
  const {site, keeper, program} = prepared;
  addEventListener('unhandledrejection', (event) => {
    if (!finished) giveUp(event.reason, keeper);  // the program broke
  });
  await admitForgetting(keeper);
  const screen = await measureScreen(site);
  if (!site.phones) requireLargeEnough();
  writeFacts(program, site, layOut(), keeper, screen);
  listen(() => finished);
  tell('…', []);  // the program measures frames, for seconds
  const ending = await program.ccall('run_page', 'string', [], [], {async: true});
  finished = true;
  if (document.fullscreenElement) await document.exitFullscreen();
  if (ending === 'finished' && site.completion && !experiment()) return location.assign(site.completion);
  if (!experiment()) {
    $('page').append(...await downloadsOf(keeper));
    document.querySelectorAll('#page a').forEach((file) => file.click());
  }
  return end(ending, keeper);
}

run().catch((error) => {
  tell(text('page_cannot_go_on'), [error.message]);
  return end('failed');
});
