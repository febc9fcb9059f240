"""Somebody who takes part in a published study: reads each page, answers it with keys and mouse, and
looks where the mouse is.

Usage: participant.py BROWSER LINK [WIDTH HEIGHT [PICTURES]]. Prints how the session ended, and what the page
asked of other origins, which is to be nothing. With PICTURES, a folder, every page is photographed.
"""
import math
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
const told = document.body?.dataset.ending;
const shown = document.querySelector('iframe')?.contentDocument ?? document;
const page = shown.getElementById('page');
const target = shown.getElementById('target');
const left = (name) => shown.querySelector(name)?.getBoundingClientRect().x ?? 0;
return page === null || told ? {ending: told ?? '', link: location.href, words: page?.innerText ?? ''} : {
  ending: '',
  picture: shown.body.classList.contains('picture'),
  kind: page.className,
  words: page.innerText,
  listens: page.getAttribute('aria-busy') === 'false',
  buttons: [...page.querySelectorAll('button')].map(place),
  fields: [...page.querySelectorAll('input, select, textarea')].map(place),
  card: shown.querySelector('.card')?.clientWidth ?? 0,
  apart: left('#blind-spot .cross') - left('#blind-spot .dot'),
  target: target && !target.hidden ? place(target) : null,
  width: innerWidth, height: innerHeight,
};"""

FOCUS = "return (document.querySelector('iframe')?.contentDocument ?? document).activeElement.tagName;"


def fill(browser, count):
    """Types into every field, with the keys alone: the first has the focus already."""
    for index in range(count):
        tag = browser.ask(FOCUS)
        if tag == "SELECT":
            browser.press("down")
        else:
            browser.type("33" if tag == "INPUT" else "I “looked” <b>closely</b>.")
        browser.press("tab")


CARD_PX = 340  # how wide a bank card is on this participant's screen
DISTANCE_M = 0.57


def blind_spot_px():
    """How far from the cross a dot disappears."""
    return DISTANCE_M * math.tan(math.radians(13.5)) * CARD_PX / 0.0856


def answer(browser, page):
    """Does what a willing participant does with the page."""
    if page["card"]:
        while browser.ask(LOOK)["card"] < CARD_PX - 2:  # its borders are no part of that
            browser.press("right")
        return browser.press("enter")
    if page["fields"]:
        fill(browser, len(page["fields"]))
    if page["kind"] == "scale":
        return browser.press(str(min(3, len(page["buttons"]))))
    if "agree" in page["buttons"][0]["label"]:
        browser.press("page down")
        return browser.press("y")
    button = page["buttons"][0]
    if button["y"] > page["height"]:
        browser.press("page down")
        button = browser.ask(LOOK)["buttons"][0]
    browser.click(button["x"], button["y"])


def take_part(browser, link, longest_s, pictures=None):
    """Takes part for so long, from the first page to the last; how the session ended."""
    browser.go(link)
    count, begun, end = 0, False, time.time() + 120
    while time.time() < end:
        page = browser.ask(LOOK)
        if page["ending"]:
            return page["ending"] + (": " + re.sub(r"\s+", " ", page["words"]) if page["ending"] == "failed" else "")
        if "link" in page:  # nothing is shown yet, or a page of others
            if page["link"].startswith("http") and not page["link"].startswith(link.split("?")[0]):
                return page["link"]
            time.sleep(0.02)
            if page["link"].startswith("chrome-error"):  # nobody served it: it is asked for again
                time.sleep(1)
                browser.go(link)
            continue
        if page["listens"] and not begun:
            begun, end = True, time.time() + longest_s
        if page["apart"] > blind_spot_px():
            browser.press("space")
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
    return "not ended: " + re.sub(r"\s+", " ", page["words"])


def strays(browser, link):
    """What the page asked of other origins than its own, and what it did against its policy."""
    own = ("/".join(link.split("/")[:3]) + "/", "data:", "blob:")
    return [f"the page asked for {asked}" for asked in browser.asked() if not asked.startswith(own)] + \
        [f"the browser complained: {complaint}" for complaint in browser.complaints()]


if __name__ == "__main__":
    program, link, *more = sys.argv[1:]
    width, height = (int(more[0]), int(more[1])) if len(more) > 1 else (960, 720)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        with open_browser(program, folder, width, height) as opened:
            ending = take_part(opened, link, 600, more[2] if len(more) > 2 else None)
            print("; ".join([ending, *strays(opened, link)]))
