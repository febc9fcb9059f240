"""Which frames of films Chromium presents, as it tells itself.

presented.py FOLDER FILM...: each FILM lies in FOLDER beside its JSON, which tells how many frames it has and
when. Ends with an error unless each was presented once, in its turn, within half a frame of its time. Played
at a quarter of the speed: a machine without a graphics card presents 15 frames a second, not always 60.
"""
import json
import os
import sys

from browsers import open_browser, see_through

PAGE = """<!doctype html>
<meta charset="utf-8">
<video muted></video>
<script>
window.presented = [];
const video = document.querySelector('video');
const note = (now, frame) => {
  window.presented.push([frame.presentedFrames, frame.mediaTime]);
  video.requestVideoFrameCallback(note);
};
video.requestVideoFrameCallback(note);  // before there is a film: its first frame is presented when it is loaded
video.addEventListener('ended', () => { window.ended = true; });
video.addEventListener('error', () => { window.failed = video.error.message; });
video.addEventListener('canplaythrough', () => { video.playbackRate = 0.25; video.play(); }, {once: true});
video.src = 'FILM';
</script>
"""


def presented(browser, folder, film):
    page = os.path.join(folder, film + ".html")
    with open(page, "w") as out:
        out.write(PAGE.replace("FILM", film))
    see_through(browser, "file://" + page, 120)
    return browser.ask("return window.presented;")


def check(film, frames, refresh_hz, seen):
    """Throws unless every frame was presented, once, at its time."""
    numbers = [round(time_s * refresh_hz) for _, time_s in seen]
    missing = sorted(set(range(frames)) - set(numbers))
    if missing or numbers != sorted(numbers) or numbers[-1] != frames - 1:
        raise ValueError(f"{film}: of {frames} frames, {missing} were not presented; got {numbers}")
    worst_s = max(abs(time_s - number / refresh_hz) for number, (_, time_s) in zip(numbers, seen))
    if worst_s > 0.5 / refresh_hz:
        raise ValueError(f"{film}: a frame stands {worst_s * 1000:.1f} ms from its time")
    return worst_s


def main():
    folder, films = sys.argv[1], sys.argv[2:]
    with open_browser("chromium", os.path.join(folder, "browser"), 800, 600) as browser:
        for film in films:
            with open(os.path.join(folder, os.path.splitext(film)[0] + ".json")) as told:
                record = json.load(told)
            frames, refresh_hz = len(record["frames"]), record["frames_per_second"]
            for attempt in range(3):  # a machine that is busy may be late for one
                seen = presented(browser, folder, film)
                try:
                    worst_s = check(film, frames, refresh_hz, seen)
                    break
                except ValueError as error:
                    if attempt == 2:
                        sys.exit(str(error))
            try:
                check(film, frames, refresh_hz, seen[: len(seen) // 2] + seen[len(seen) // 2 + 1:])
                sys.exit("a frame that was left out was not noticed")
            except ValueError:
                pass
            print(f"{film}: {frames} frames presented, each within {worst_s * 1000:.2f} ms of its time")


main()
