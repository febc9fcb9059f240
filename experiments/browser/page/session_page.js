// What a session in a page asks of its browser: pages as HTML, frames, keys and the mouse, and lines
// of the record taken to where they are kept. The session itself is WebAssembly (impetus.wasm), the
// program's own; it waits for what these functions promise.
//

import {Keeper} from './keeper.js';

const $ = (id) => document.getElementById(id);
const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children.filter((child) => child !== null));
  return made;
}

// ---------------------------------------------------------------- what this page is told

const link = new URLSearchParams(location.search);

/** The step of the page's clock: what stamps of events can tell apart at best. */
function clockStep() {
  let step = Infinity;
  for (let i = 0; i < 20; ++i) {
    const from = performance.now();
    let to = from;
    while (to === from) to = performance.now();
    step = Math.min(step, to - from);
  }
  return step;
}

function rendererName() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'none';
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

function showTrouble(words) {
  let trouble = $('trouble');
  if (!trouble && words) {
    trouble = element('p', {id: 'trouble', className: 'hint'});
    trouble.setAttribute('role', 'alert');
    $('label').before(trouble);
    $('progress').hidden = false;
  }
  if (trouble) trouble.textContent = words;
}

// ---------------------------------------------------------------- what the program asks

let moves = [];
let clicks = [];
let pauseAsked = false;
let away = false;
let absences = [];
let step_ms = 1;

const kKeyNames = {' ': 'space', Enter: 'enter', Escape: 'escape'};
const keyName = (event) => kKeyNames[event.key] || event.key.toLowerCase();

/** Where an event was, in pixels of the picture. */
const place = (event) => [event.clientX * devicePixelRatio, event.clientY * devicePixelRatio];

function listen() {
  addEventListener('pointermove', (event) => {
    away = false;
    for (const each of event.getCoalescedEvents?.() ?? [event]) {
      moves.push([each.timeStamp, ...place(each)]);
    }
  });
  document.documentElement.addEventListener('pointerleave', () => { away = true; });
  addEventListener('pointerdown', (event) => clicks.push(['mouse', event.timeStamp, step_ms]));
  addEventListener('keydown', (event) => {
    if (event.repeat) return;
    if (event.key === ' ') clicks.push(['key', event.timeStamp, step_ms]);
    if (event.key === 'Escape') pauseAsked = true;
  });
  addEventListener('visibilitychange', () => { pauseAsked ||= document.hidden; });
  noteAbsences('page hidden', () => document.hidden, ['visibilitychange']);
  noteAbsences('page without focus', () => !document.hasFocus(), ['focus', 'blur']);
  addEventListener('beforeunload', (event) => { if (!finished) event.preventDefault(); });
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

let finished = false;

function fieldOf(field, index) {
  const id = `field-${index}`;
  let input;
  if (field.kind === 'choice') {
    input = element('select', {id}, element('option', {value: ''}),
      ...field.options.map((option) => element('option', {value: option, textContent: option})));
  } else if (field.kind === 'number') {
    input = element('input', {id, inputMode: 'decimal', autocomplete: 'off'});
  } else {
    input = element('textarea', {id, rows: 3, maxLength: 10000});
  }
  const problem = element('p', {className: 'problem', id: `${id}-problem`});
  input.setAttribute('aria-describedby', problem.id);
  return element('div', {className: 'field'},
    element('label', {htmlFor: id, textContent: field.label}), input, problem);
}

/** Whether what was typed can stand; says under the field why not. */
function checkField(field, index) {
  const input = $(`field-${index}`);
  const text = input.value.trim();
  let problem = '';
  if (field.kind === 'number' && text !== '') {
    const number = Number(text.replace(',', '.'));
    if (Number.isNaN(number) || number < field.minimum || number > field.maximum) {
      problem = `${field.minimum} – ${field.maximum}`;
    }
  }
  $(`field-${index}-problem`).textContent = problem;
  input.setAttribute('aria-invalid', String(problem !== ''));
  return problem === '';
}

function mapOf(page) {
  const width = 1000 * page.aspect;
  const map = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  map.setAttribute('viewBox', `0 0 ${width} 1000`);
  map.setAttribute('class', 'map');
  const dot = (x, y, radius, fill) => {
    const circle = document.createElementNS(map.namespaceURI, 'circle');
    Object.entries({cx: (0.5 + x) * width, cy: (0.5 - y) * 1000, r: radius, fill})
      .forEach(([name, value]) => circle.setAttribute(name, value));
    map.append(circle);
  };
  for (const [x, y, seen, gazeX, gazeY] of page.points) {
    dot(x, y, 16, '#18181a');
    if (seen) dot(gazeX, gazeY, 10, '#22527c');
  }
  return map;
}

function build(page) {
  const main = $('page');
  main.className = page.layout;
  main.replaceChildren(...[
    page.title ? element('h1', {textContent: page.title, tabIndex: -1}) : null,
    ...page.paragraphs.map((text) => element('p', {textContent: text})),
    page.statement ? element('p', {className: 'statement', textContent: page.statement}) : null,
    page.points.length > 0 ? mapOf(page) : null,
    ...page.fields.map(fieldOf),
  ].filter((each) => each !== null));
  const buttons = page.choices.map((choice) => element('button', {type: 'button'}, choice.label));
  const large = page.layout === 'scale' || page.layout === 'choices';
  main.append(element('div', {className: large ? 'choices large' : 'choices'}, ...buttons));
  if (page.low_anchor || page.high_anchor) {
    main.append(element('div', {className: 'anchors'}, element('span', {textContent: page.low_anchor}),
      element('span', {textContent: page.high_anchor})));
  }
  main.append(element('div', {id: 'end'}));
  return buttons;
}

/** Shows a page until it is answered; everything about it is undone afterwards. */
async function ask(page) {
  document.body.className = page.progress.light ? 'light' : '';
  showProgress(page.progress);
  const buttons = build(page);
  const over = new AbortController();
  const listening = {signal: over.signal};
  scrollTo(0, 0);
  const first = page.fields.length > 0 ? $('field-0') : page.title ? document.querySelector('h1') : null;
  first?.focus({preventScroll: true});
  const shown_ms = await frame();
  let endSeen = page.choice_at_end === null;
  const observer = new IntersectionObserver((seen) => {
    endSeen ||= seen.some((each) => each.isIntersecting);
  });
  observer.observe($('end'));

  const answer = await new Promise((resolve) => {
    const leave = (more) => resolve({choice: 0, device: 'none', arrived_ms: performance.now(),
      timed_out: false, pause: false, ...more});
    const choose = (choice, device, event) => {
      if (choice === page.choice_at_end && !endSeen) {
        if (!$('hasty')) {
          $('end').before(element('p', {id: 'hasty', className: 'hint', textContent: page.read_to_end}));
        }
        return;
      }
      const refused = page.choices[choice].key === 'escape' ? [] :
        page.fields.map((field, index) => [index, checkField(field, index)]).filter(([, good]) => !good);
      if (refused.length > 0) return $(`field-${refused[0][0]}`).focus();
      leave({choice, device, arrived_ms: event.timeStamp});
    };
    // A press of the enter or space key clicks a focused button, too: its stamp is the key's.
    let pressed = null;
    buttons.forEach((button, choice) => button.addEventListener('click', (event) => {
      choose(choice, event.detail === 0 ? 'key' : 'mouse', event.detail === 0 && pressed ? pressed : event);
    }, listening));
    addEventListener('keydown', (event) => {
      if (event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
      pressed = event;
      const name = keyName(event);
      const typing = ['INPUT', 'TEXTAREA', 'SELECT'].includes(document.activeElement?.tagName);
      const onButton = document.activeElement?.tagName === 'BUTTON';
      const choice = page.choices.findIndex((each) => each.key === name);
      if (choice >= 0 && !(typing && (name.length === 1 || name === 'space' || name === 'enter')) &&
          !(onButton && (name === 'enter' || name === 'space'))) {
        event.preventDefault();
        choose(choice, 'key', event);
      } else if (name === 'escape' && page.can_pause) {
        leave({pause: true, device: 'key', arrived_ms: event.timeStamp});
      } else if (typing && name === 'enter' && document.activeElement.tagName === 'INPUT') {
        const inputs = [...document.querySelectorAll('#page input, #page select, #page textarea, #page button')];
        inputs[inputs.indexOf(document.activeElement) + 1]?.focus();
        event.preventDefault();
      }
    }, listening);
    $('page').setAttribute('aria-busy', 'false');  // it listens, until it is answered
    if (page.timeout_ms > 0) {
      const time = element('div', {className: 'time'});
      $('end').before(time);
      time.animate([{width: '100%'}, {width: '0'}], page.timeout_ms);
      const timer = setTimeout(() => leave({timed_out: true}), page.timeout_ms);
      over.signal.addEventListener('abort', () => clearTimeout(timer));
    }
  });
  const fields = page.fields.map((field, index) => {
    const text = $(`field-${index}`).value.trim();
    return field.kind === 'number' ? text.replace(',', '.') : text;
  });
  $('page').setAttribute('aria-busy', 'true');
  over.abort();
  observer.disconnect();
  return {...answer, fields, shown_ms, uncertainty_ms: step_ms};
}

function showProgress(progress) {
  $('progress').hidden = progress.total === 0 && progress.label === '';
  $('done').style.width = `${progress.total > 0 ? 100 * progress.done / progress.total : 0}%`;
  $('label').textContent = progress.label;
}

function asksOf(keeper) {
  return {
    nextFrame: frame,
    ask: async (text) => JSON.stringify(await ask(JSON.parse(text))),
    awaitSaved: (standing) => keeper.keep(standing).catch(refuse),
    handOver: (line) => keeper.add(line),
    takeEvents: () => {
      const events = JSON.stringify({moves, clicks, away, absences, pause: pauseAsked});
      absences = [];
      moves = [];
      clicks = [];
      pauseAsked = false;
      return events;
    },
    showProgress: (text) => showProgress(JSON.parse(text)),
    showTarget: (on, x, y) => {
      $('target').hidden = !on;
      $('target').style.left = `${x / devicePixelRatio}px`;
      $('target').style.top = `${y / devicePixelRatio}px`;
    },
    showPicture: (withPointer) => {
      document.body.className = withPointer ? 'picture' : 'picture no-pointer';
    },
    tell: (sentence) => tell('This study cannot go on', [sentence]),
  };
}

function tell(title, paragraphs, ...more) {
  document.body.className = '';
  $('page').className = 'text';
  $('page').replaceChildren(element('h1', {textContent: title}),
    ...paragraphs.map((text) => element('p', {textContent: text})), ...more);
}

// ---------------------------------------------------------------- a session from first to last

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
  document.documentElement.dir = site.language === 'ar' ? 'rtl' : 'ltr';
  document.title = site.title;
  if (matchMedia('(pointer: coarse) and (hover: none)').matches && !site.phones) {
    throw new Error('This study needs a computer with a keyboard and a mouse: it cannot be shown on a phone.');
  }
  const keeper = new Keeper(site, link, (problem) => showTrouble(problem &&
    `What was answered could not be sent yet (${problem}). Please keep this page open; it tries again.`));
  const standing = await keeper.begin();
  if (keeper.finished) {
    tell('You have taken part in this study already', ['Thank you.'], ...await downloadsOf(keeper));
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

function writeFacts(program, canvas, keeper) {
  step_ms = clockStep();
  program.FS.writeFile('/facts.json', JSON.stringify({
    participant: keeper.code,
    seed: Number(link.get('seed') ?? 1),
    machine: navigator.userAgent,
    display: `page of ${canvas.width} x ${canvas.height} px at a pixel ratio of ${devicePixelRatio}; ` +
      `${rendererName()}; clock step ${step_ms.toFixed(3)} ms${window.crossOriginIsolated ? ', isolated' : ''}; ` +
      'flip stamp: begin of the frame after the one that was drawn in; size and distance assumed',
    width_px: canvas.width,
    height_px: canvas.height,
  }));
}

/** What is kept in this browser alone, for the participant to hand over. */
async function downloadsOf(keeper) {
  return (await keeper.files()).map(([name, lines]) => {
    const file = URL.createObjectURL(new Blob([lines], {type: 'application/jsonl'}));
    return element('p', {}, element('a', {href: file, download: name, textContent: name}));
  });
}

/** What was answered will not be taken: nothing more is asked. */
function refuse(error) {
  finished = true;
  tell('This study cannot go on', [error.message]);
  return new Promise(() => {});
}

async function run() {
  const prepared = await prepare();
  if (!prepared) return;
  const {site, keeper, program} = prepared;
  const canvas = layOut();
  writeFacts(program, canvas, keeper);
  listen();
  const ending = await program.ccall('run_page', 'string', [], [], {async: true});
  finished = true;
  if (ending === 'failed') return;
  if (ending === 'finished' && site.completion) return location.assign(site.completion);
  if (!site.drop) {
    $('page').append(...await downloadsOf(keeper));
    document.querySelectorAll('#page a').forEach((file) => file.click());
  }
  document.body.dataset.ending = ending;
}

run().catch((error) => tell('This study cannot go on', [error.message]));
