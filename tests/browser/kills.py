"""Participants whose browser is killed at random, again and again, one after the other; now and then the program
that serves them is killed, too. What was acknowledged is kept, and in the end each trial is there once.

Usage: kills.py PROGRAM PAGE PROTOCOL STUDY BROWSER KILLS. PAGE is the folder of what runs in a page.
"""
import contextlib
import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

from browsers import open_browser
from participant import take_part

program, page, protocol, study, browser_program, kills = sys.argv[1:]
chance = random.Random(7)


class Serving:
    """The program that serves the study, at one port however often it is killed."""

    def __init__(self):
        self.port, self.killed = 0, 0
        self.begin()

    def begin(self):
        self.process = subprocess.Popen(
            [program, "serve", protocol, "--db", study, "--port", str(self.port), "--program", page,
             "--assume-screen", "--in-window", "--allow-failed-sync"], stdout=subprocess.PIPE, text=True)
        self.port = int(self.process.stdout.readline().split("http://127.0.0.1:")[1].split("/")[0])

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.killed += 1
        self.begin()

    def end(self):
        self.process.terminate()
        self.process.wait()


def asked(question):
    with contextlib.closing(sqlite3.connect(f"file:{study}?mode=ro", uri=True)) as database:
        return database.execute(question).fetchall()


def kept_trials():
    """The trials that are completed."""
    rows = asked("SELECT participant_id, slot, count(*) FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
                 "JOIN attempt ON attempt.trial_id = trial.id WHERE outcome = 'completed' GROUP BY 1, 2")
    assert all(count == 1 for *_, count in rows), f"trials more than once: {rows}"
    return {(participant, slot) for participant, slot, _ in rows}


def acknowledged_parts(browser):
    """The parts of which the browser was told that they are kept: the session's name, and the part's number."""
    posted, parts = {}, set()
    for message in browser.heard():
        told = message["params"]
        if message["method"] == "Network.requestWillBeSent" and told["request"]["url"].endswith("/parts"):
            posted[told["requestId"]] = json.loads(told["request"]["postData"])["filename"]
        elif message["method"] == "Network.responseReceived" and told["requestId"] in posted and \
                told["response"]["status"] == 200:
            name, number = posted[told["requestId"]].removesuffix(".jsonl").rsplit("_", 1)
            parts.add((name, int(number)))
    return parts


def require_kept(parts):
    kept = dict(asked("SELECT page_name, page_parts FROM session"))
    for name, number in parts:
        assert kept.get(name, 0) >= number, f"{name}: part {number} was acknowledged, {kept.get(name, 0)} are kept"


def live(link, profile, life_s):
    """Takes part for so long from the first page on, and is killed; how the session ended, and what was
    acknowledged."""
    with open_browser(browser_program, profile, 960, 720) as browser:
        try:
            ending = take_part(browser, link, life_s)
        except (RuntimeError, KeyError) as error:  # the page was just on its way
            ending = f"not ended: {error}"
        finally:
            os.killpg(browser.process.pid, signal.SIGKILL)
            browser.process.wait()
        return ending, acknowledged_parts(browser)


begun = time.time()
with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    serving = Serving()
    lives, killed, participants, before, acknowledged, ending = 0, 0, 0, set(), set(), "finished"
    while killed < int(kills) or ending != "finished":
        if ending == "finished":
            participants += 1
            key = f"{chance.getrandbits(128):032x}"
        link = f"http://127.0.0.1:{serving.port}/?participant=P{participants:02}&key={key}"
        life_s = chance.uniform(0.0, 12.0) if killed < int(kills) else 900.0
        program_dies = chance.random() < 0.2
        death = threading.Timer(chance.uniform(0.0, 15.0), serving.kill)
        if program_dies:
            death.start()
        ending, parts = live(link, os.path.join(folder, str(lives % 3)), life_s)  # three browsers take turns
        if program_dies:
            death.join()
        lives += 1
        killed += ending != "finished"
        acknowledged |= parts
        require_kept(acknowledged)
        now = kept_trials()
        assert before <= now, f"lost: {before - now}"
        before = now
        print(f"{time.time() - begun:.0f} s, P{participants:02}, life {lives} of {life_s:.1f} s"
              f"{', the program died' if program_dies else ''}: {len(now)} trials; {ending[:70]}", flush=True)
        # A page that had just begun to load when the program died says so.
        assert ending == "finished" or ending.startswith("not ended") or program_dies, ending
        assert lives <= int(kills) + 5 + participants, "the last lives were long enough"
    serving.end()
steps, = asked("SELECT count(*) FROM step")[0]
print(f"{killed} browsers and {serving.killed} programs were killed in {(time.time() - begun) / 60:.0f} min: "
      f"{len(acknowledged)} acknowledged parts and {len(before)} trials of {participants} participants, {steps} steps, "
      "each once.")
