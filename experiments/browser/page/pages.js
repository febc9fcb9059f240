// Pages as HTML, which keyboards operate and screen readers read; one is shown until it is answered.

import {clockStep_ms} from './browser_facts.js';
import {text} from './words.js';

export const $ = (id) => document.getElementById(id);
export const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));

/** An element with these properties and children; null is none. */
export function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children.filter((child) => child !== null));
  return made;
}

const kKeyNames = {' ': 'space', Enter: 'enter', Escape: 'escape'};

/** The key's letter; on a keyboard of another script, the Latin one in its place. */
function keyName(event) {
  const isOfAnotherScript = /^[^\x00-\x7f]$/.test(event.key) && /^Key[A-Z]$/.test(event.code);
  return kKeyNames[event.key] || (isOfAnotherScript ? event.code[3] : event.key).toLowerCase();
}

function fieldOf(field, index) {
  const id = `field-${index}`;
  let input;
  if (field.kind === 'choice') {
    input = element('select', {id}, element('option', {value: ''}),
      ...field.options.map((option) => element('option', {value: option, textContent: option})));
  } else if (field.kind === 'number') {
    input = element('input', {id, inputMode: 'decimal', autocomplete: 'off'});
  } else if (field.kind === 'slider') {
    input = element('input', {id, type: 'range', className: 'unset', min: field.minimum, max: field.maximum, step: 1});
    input.value = (field.minimum + field.maximum) / 2;
    const set = () => input.classList.remove('unset');
    ['input', 'pointerdown'].forEach((happening) => input.addEventListener(happening, set));
    input.addEventListener('keydown', (event) => event.key.startsWith('Arrow') && set());
  } else {
    input = element('textarea', {id, rows: 3, maxLength: 10000, dir: 'auto'});
  }
  if (field.answer) {
    input.value = field.answer;
    input.classList.remove('unset');
  }
  const problem = element('p', {className: 'problem', id: `${id}-problem`});
  input.setAttribute('aria-describedby', problem.id);
  const label = field.label ? element('label', {htmlFor: id, textContent: field.label}) : null;
  if (!field.label) input.setAttribute('aria-labelledby', 'question');
  const words = field.kind !== 'slider' ? null : element('div', {className: 'anchors'},
    ...field.options.map((textContent) => element('span', {textContent})));
  if (words) words.style.gridTemplateColumns = `1fr${' 2fr'.repeat(field.options.length - 2)} 1fr`;
  return element('div', {className: 'field'}, label, input, words, problem);
}

/** Whether what was typed can stand; says under the field why not. */
function checkField(field, index) {
  const input = $(`field-${index}`);
  const typed = input.value.trim();
  let problem = '';
  if (field.kind === 'number' && typed !== '') {
    const number = Number(typed.replace(',', '.'));
    const {minimum: least, maximum: most} = field;  // null: there is none
    if (Number.isNaN(number) || (least !== null && (number < least || number > most))) {
      problem = least === null ? text('number_needed') : text('number_within', {least, most});
    }
  }
  if (input.classList.contains('unset')) problem = text('mark_needed');
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

/** The key of a choice as it is printed: "" where its label says it already, or nobody presses it. */
function printedKey({label, key}) {
  const name = {space: 'space_bar', enter: 'enter', escape: 'escape'}[key];
  if (name) return text(name);
  return key.length === 1 && key !== label.toLowerCase() ? key.toUpperCase() : '';
}

function buttonOf(choice) {
  const key = printedKey(choice);
  return element('button', {type: 'button'}, choice.label,
    key ? element('span', {className: 'key', textContent: `(${key})`}) : null);
}

const kAbreast = 60;  // letters of large choices that stand side by side

function build(page) {
  const main = $('page');
  main.className = page.layout;
  main.replaceChildren(...[
    page.title ? element('h1', {id: 'question', textContent: page.title, tabIndex: -1}) : null,
    ...page.paragraphs.map((words) => element('p', {textContent: words})),
    page.statement ? element('p', {className: 'statement', textContent: page.statement}) : null,
    page.points.length > 0 ? mapOf(page) : null,
    page.figure ?? null,
    ...page.fields.map(fieldOf),
  ].filter((each) => each !== null));
  const buttons = page.choices.map(buttonOf);
  const large = page.layout === 'scale' || page.layout === 'choices';
  const below = page.layout === 'choices' && page.choices.some(({label}) => label.length > kAbreast / page.choices.length);
  main.append(element('div', {className: `choices${large ? ' large' : ''}${below ? ' below' : ''}`}, ...buttons));
  if (page.low_anchor || page.high_anchor) {
    main.append(element('div', {className: 'anchors'}, element('span', {textContent: page.low_anchor}),
      element('span', {textContent: page.high_anchor})));
  }
  if (page.layout === 'scale' && page.choices.length > 1) {
    const [first, last] = [page.choices[0], page.choices.at(-1)].map(({key}) => key.toUpperCase());
    main.append(element('p', {className: 'quiet', textContent: text('press_or_click', {first, last})}));
  }
  main.append(element('div', {id: 'end'}));
  return buttons;
}

let shownProgress = {done: 0, total: 0, label: '', light: false};

/** A page of the page's own, as the program would describe it. */
export function ownPage(facts) {
  return {layout: 'text', paragraphs: [], statement: '', fields: [], points: [], low_anchor: '', high_anchor: '',
    timeout_ms: 0, can_pause: false, choice_at_end: null, ...facts, progress: shownProgress};
}

/** Shows a page until it is answered; everything about it is undone afterwards. Beyond what the program
    says of it: `figure`, an element below its words; `focus`, what has the focus first; `answered()`,
    called within the key or click that answers it. */
export async function ask(page) {
  document.body.className = page.progress.light ? 'light' : '';
  showProgress(page.progress);
  const buttons = build(page);
  const over = new AbortController();
  const listening = {signal: over.signal};
  scrollTo(0, 0);
  const first = page.focus ?? $('field-0') ?? document.querySelector('#page h1');
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
      page.answered?.();
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
      const typing = document.activeElement?.matches('input:not([type=range]), textarea, select');
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
    if ($(`field-${index}`).classList.contains('unset')) return '';
    const typed = $(`field-${index}`).value.trim();
    return field.kind === 'number' ? typed.replace(',', '.') : typed;
  });
  $('page').setAttribute('aria-busy', 'true');
  over.abort();
  observer.disconnect();
  return {...answer, fields, shown_ms, uncertainty_ms: clockStep_ms()};
}

/** How far the session has come, along the bottom edge. */
export function showProgress(progress) {
  shownProgress = progress;
  $('progress').hidden = progress.total === 0 && progress.label === '';
  $('done').style.width = `${progress.total > 0 ? 100 * progress.done / progress.total : 0}%`;
  $('label').textContent = progress.label;
}

/** What is the matter just now, above the progress; "": nothing is. */
export function showTrouble(words) {
  let trouble = $('trouble');
  if (!trouble && words) {
    trouble = element('p', {id: 'trouble', className: 'hint'});
    trouble.setAttribute('role', 'alert');
    $('label').before(trouble);
    $('progress').hidden = false;
  }
  if (trouble) trouble.textContent = words;
}

/** A page that nobody answers. */
export function tell(title, paragraphs, ...more) {
  document.body.className = '';
  $('page').className = 'text';
  $('page').replaceChildren(element('h1', {textContent: title}),
    ...paragraphs.map((words) => element('p', {textContent: words})), ...more);
}

