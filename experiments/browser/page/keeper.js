// Lines of the record, taken to where they are kept, in order, for as long as it takes. What is on its
// way, and where the participant then stands, is in this browser's own store, so that a page that is
// closed at any moment, and opened again, loses and doubles nothing:
//
//   part ──remembered──> posted until it is acknowledged ──> the new standing is remembered
//
// A browser that can remember nothing goes on without, as long as its page is open. What is refused for good
// is set aside for the participant to hand over. Lines are passed on unread: their numbers have 64 bits.

import {text} from './words.js';

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function random(letter, bytes) {
  const drawn = crypto.getRandomValues(new Uint8Array(bytes));
  return letter + [...drawn].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

// ---------------------------------------------------------------- this browser's own store

const opened = new Promise((resolve) => {
  const opening = indexedDB.open('impetus', 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore('sessions');
  opening.onsuccess = () => resolve(opening.result);
  opening.onerror = () => resolve(null);  // a private window may have none: nothing is remembered
});

async function inStore(mode, act) {
  const database = await opened;
  if (!database) return undefined;
  return new Promise((resolve, reject) => {
    const transaction = database.transaction('sessions', mode, {durability: 'strict'});
    const asked = act(transaction.objectStore('sessions'));
    transaction.oncomplete = () => resolve(asked.result);
    transaction.onerror = transaction.onabort = () => reject(transaction.error);
  });
}

const recall = (name) => inStore('readonly', (store) => store.get(name)).catch(() => undefined);

/** Whether it will be there when the page is opened again: a store may be full, or none. */
const remember = (name, value) => inStore('readwrite', (store) => store.put(value, name))
  .then((key) => key !== undefined, () => false);

// ---------------------------------------------------------------- posts

/** Posts JSON. Returns {answer} when it was taken, {refused} when it never will be, else {problem}. */
async function post(url, body) {
  try {
    const answer = await fetch(url, {
      method: 'POST',
      headers: {'Content-Type': 'application/json', Accept: '*/*'},
      body: JSON.stringify(body),
      signal: AbortSignal.timeout(30000),
    });
    // A file that a drop has already was kept, though its answer was lost.
    if (answer.ok || answer.status === 409) return {answer};
    if (answer.status === 403 || answer.status === 422) {
      const words = await answer.json().catch(() => ({}));
      return {refused: words.refused ?? text('page_server_answered', {status: answer.status})};
    }
    return {problem: text('page_server_answered', {status: answer.status})};
  } catch (error) {
    return {problem: text('page_no_connection')};
  }
}

/** What was sent will never be taken; the message says why. */
class Refused extends Error {}

/** Tries until it was taken or is refused; says in between what is the matter. */
async function postUntilTaken(url, body, showTrouble) {
  for (let wait_ms = 500; ; wait_ms = Math.min(2 * wait_ms, 15000)) {
    const {answer, refused, problem} = await post(url, body);
    showTrouble(problem ?? '');
    if (answer) return answer;
    if (refused) throw new Refused(refused);
    await pause(wait_ms);
  }
}

/** Takes one participant's lines to where the site keeps them. */
export class Keeper {
  /** `link`: of the page; `showTrouble(words)`: what is the matter just now, '' when nothing is. */
  constructor(site, link, showTrouble) {
    this.site = site;
    this.showTrouble = showTrouble;
    // Of the link, by whichever name a service gives it; else one that nobody can guess.
    this.code = link.get('participant') || link.get('PROLIFIC_PID') || link.get('workerId') ||
      link.get('SESSION_ID') || random('W', 8);
    this.key = link.get('key');
    this.name = `${this.code}_${new Date().toISOString().replace(/[-:.]/g, '')}`;
    this.place = `${site.study}|${this.code}`;
    this.waiting = [];
    this.parts = 0;
    this.going = Promise.resolve();
    this.forgetful = false;
    this.held = new Map();  // what this browser's store did not take
  }

  /** Sends what an earlier page left on its way; returns where the participant stands, or null. */
  async begin() {
    this.memory = {key: random('', 16), files: [], refused: [], ...await recall(this.place)};
    this.key ??= this.memory.key;
    this.memory.key = this.key;
    await this.remember(this.place, this.memory);
    if (this.memory.pending) await this.sendAgain(this.memory.pending);
    // From now on the page's address is the participant's own link, which goes on.
    const own = new URL(location.href);
    own.searchParams.set('participant', this.code);
    own.searchParams.set('key', this.key);
    history.replaceState(null, '', own);
    if (this.site.standing) {
      const asked = {participant: this.code, key: this.key};
      const answer = await postUntilTaken(this.site.standing, asked, this.showTrouble);
      const standing = await answer.json();
      this.memory.finished = standing?.finished ?? false;
      return standing && {standing, age_s: 0};  // the server knows for how long nobody was there
    }
    const {standing, at} = this.memory;
    return standing ? {standing: JSON.parse(standing), age_s: (Date.now() - at) / 1000} : null;
  }

  /** Whether the participant has done everything, in whichever page. */
  get finished() {
    return this.memory.finished ?? false;
  }

  add(line) {
    this.waiting.push(line);
  }

  /** Sends what waits as one file; resolves when it is kept, and the participant stands here. */
  keep(standing) {
    this.going = this.going.then(async () => {
      if (this.waiting.length === 0) return;
      const data = this.waiting.join('\n') + '\n';
      this.waiting = [];
      const number = String(++this.parts).padStart(4, '0');
      const finished = data.includes('"kind":"finished"');  // no answer has it: its quotes are escaped
      await this.send({filename: `${this.name}_${number}.jsonl`, data, standing, finished});
    });
    return this.going;
  }

  async send(part) {
    this.memory.pending = part;
    await this.remember(this.place, this.memory);
    const {drop} = this.site;
    if (drop) {
      await this.post(drop, part);
    } else {
      await this.setAside(part, this.memory.files);
    }
    const {standing, finished} = part;
    Object.assign(this.memory, {pending: null, standing, finished, at: Date.now()});
    await this.remember(this.place, this.memory);
  }

  async post(drop, part) {
    const {filename, data} = part;
    const body = {experimentID: drop.experiment, filename, data, ...(this.site.standing ? {key: this.key} : {})};
    try {
      await postUntilTaken(drop.url, body, this.showTrouble);
    } catch (error) {
      this.memory.pending = null;
      await this.setAside(part, this.memory.refused);
      await this.remember(this.place, this.memory);
      throw error;
    }
  }

  /** What an earlier page left on its way may be of a session that went on elsewhere: this one goes on all the
      same, from what was taken. */
  async sendAgain(part) {
    try {
      await this.send(part);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
    }
  }

  async setAside({filename, data}, files) {
    await this.remember(`${this.place}|${filename}`, data);
    if (!files.includes(filename)) files.push(filename);
  }

  async remember(name, value) {
    if (await remember(name, value)) return;
    this.forgetful = true;
    this.held.set(name, value);
  }

  /** What is kept in this browser alone, a file for each session: [name, lines]. */
  async files() {
    const sessions = new Map();
    for (const file of this.memory.files) {
      const name = file.replace(/_[0-9]+\.jsonl$/, '.jsonl');
      sessions.set(name, (sessions.get(name) ?? '') + await this.linesOf(file));
    }
    return [...sessions];
  }

  /** The parts that were refused for good: [name, lines]. */
  refused() {
    return Promise.all(this.memory.refused.map(async (file) => [file, await this.linesOf(file)]));
  }

  async linesOf(file) {
    const place = `${this.place}|${file}`;
    return this.held.get(place) ?? await recall(place);
  }
}
