"""Somebody who takes part in a published study: reads each page, answers it with keys and mouse, and
looks where the mouse is.

Usage: participant.py BROWSER LINK [WIDTH HEIGHT [PICTURES]]. Prints how the session ended. With PICTURES, a
folder, every page is photographed.
"""
import os
import re
import sys
import tempfile
import time

from browsers import open_browser

# What the page shows: its kind, words, buttons and fields with their places, the point to look at.
LOOK = """
const place = (each) => { const box = each.getBoundingClientRect();
  return {tag: each.tagName, label: each.innerText, x: box.x + box.width / 2, y: box.y + box.height / 2}; };
const page = document.getElementById('page');
const target = document.getElementById('target');
return page === null ? {ending: document.readyState === 'complete' ? location.href : ''} : {
  ending: document.body.dataset.ending ?? '',
  title: document.title,
  picture: document.body.classList.contains('picture'),
  kind: page.className,
  words: page.innerText,
  label: document.getElementById('label').innerText,
  listens: page.getAttribute('aria-busy') === 'false',
  buttons: [...page.querySelectorAll('button')].map(place),
  fields: [...page.querySelectorAll('input, select, textarea')].map(place),
  target: target && !target.hidden ? place(target) : null,
  width: innerWidth, height: innerHeight,
};"""


def fill(browser, count):
    """Types into every field, with the keys alone: the first has the focus already."""
    for index in range(count):
        tag = browser.ask("return document.activeElement.tagName;")
        if tag == "SELECT":
            browser.press("down")
        else:
            browser.type("33" if tag == "INPUT" else "I “looked” <b>closely</b>.")
        browser.press("tab")


def answer(browser, page):
    """Does what a willing participant does with the page."""
    if page["fields"]:
        fill(browser, len(page["fields"]))
    if page["kind"] == "scale":
        return browser.press(str(min(3, len(page["buttons"]))))
    if "agree" in page["buttons"][0]["label"]:
        browser.press("page down")
        return browser.press("y")
    button = page["buttons"][0]
    browser.ask("document.querySelector('#page button').scrollIntoView({block: 'nearest'});")
    button = browser.ask(LOOK)["buttons"][0]
    browser.click(button["x"], button["y"])


def take_part(browser, link, longest_s, pictures=None):
    """Takes part from the first page to the last; how the session ended."""
    browser.go(link)
    count, end = 0, time.time() + longest_s
    while time.time() < end:
        page = browser.ask(LOOK)
        if page["ending"] and page["ending"] != "about:blank":
            return page["ending"]
        if "words" not in page:
            continue
        if page["target"]:
            browser.move(page["target"]["x"], page["target"]["y"])
        elif page["picture"]:
            browser.move(page["width"] / 2 + count % 40, page["height"] / 2)
        if page["listens"] and not page["picture"]:
            count += 1
            if pictures:
                browser.picture(os.path.join(pictures, f"{count:03}.png"))
            if os.environ.get("VERBOSE"):
                print(round(time.time() - end + longest_s, 1), page["kind"], repr(page["words"][:60]), flush=True)
            answer(browser, page)
        time.sleep(0.02)
    if pictures: browser.picture(os.path.join(pictures, "last.png")); print(page, browser.ask("return document.body.className+document.hasFocus()"))
    return "not ended: " + re.sub(r"\s+", " ", page["words"])


if __name__ == "__main__":
    program, link, *more = sys.argv[1:]
    width, height = (int(more[0]), int(more[1])) if len(more) > 1 else (960, 720)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        with open_browser(program, folder, width, height) as opened:
            print(take_part(opened, link, float(os.environ.get('LONG','240')), more[2] if len(more) > 2 else None))
