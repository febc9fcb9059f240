// What the page itself says, in the study's language: texts by key, from site.json.

let texts = {page_cannot_go_on: 'This study cannot go on'};  // until others are known

/** From now on, these are said. */
export function speak(siteTexts) {
  texts = siteTexts;
}

/** The text of a key, with what is to stand where it has {name}. */
export function text(key, fillings = {}) {
  return texts[key].replace(/\{(\w+)\}/g, (whole, name) => fillings[name] ?? whole);
}
