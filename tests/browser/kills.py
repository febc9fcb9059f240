"""Somebody whose browser is killed at random, again and again, until the study is done; now and then the program
that serves it is killed, too. What is kept never grows less, and in the end each trial is there once.

Usage: kills.py PROGRAM PAGE PROTOCOL STUDY BROWSER KILLS. PAGE is the folder of what runs in a page.
"""
import contextlib
import os
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile

from browsers import open_browser
from participant import take_part

program, page, protocol, study, browser_program, kills = sys.argv[1:]
chance = random.Random(7)


def begin_program(port):
    """The program that serves the study; it and its port."""
    serving = subprocess.Popen([program, "serve", protocol, "--db", study, "--port", str(port), "--program", page,
                                "--assume-screen", "--in-window", "--allow-failed-sync"],
                               stdout=subprocess.PIPE, text=True)
    words = serving.stdout.readline()
    return serving, int(words.split("http://127.0.0.1:")[1].split("/")[0])


def kept():
    """The trials that are completed."""
    with contextlib.closing(sqlite3.connect(f"file:{study}?mode=ro", uri=True)) as database:
        rows = database.execute("SELECT slot, count(*) FROM trial JOIN attempt ON attempt.trial_id = trial.id "
                                "WHERE outcome = 'completed' GROUP BY slot").fetchall()
    assert all(count == 1 for _, count in rows), f"trials more than once: {rows}"
    return {slot for slot, _ in rows}


def live(link, profile, life_s):
    """Takes part for so long and is killed; how the session ended."""
    with open_browser(browser_program, profile, 960, 720) as browser:
        try:
            return take_part(browser, link, life_s)
        except (RuntimeError, KeyError) as error:  # the page was just on its way
            return f"not ended: {error}"
        finally:
            os.killpg(browser.process.pid, signal.SIGKILL)


with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    serving, port = begin_program(0)
    link = f"http://127.0.0.1:{port}/?participant=P01&key=0123456789abcdef0123456789abcdef"
    lives, programs, before, ending = 0, 1, set(), ""
    while ending != "finished":
        if chance.random() < 0.2:
            serving.kill()
            serving.wait()
            serving, _ = begin_program(port)
            programs += 1
        life_s = chance.uniform(3.0, 12.0) if lives < int(kills) else 900.0
        ending = live(link, os.path.join(folder, str(lives % 3)), life_s)  # three browsers take turns
        lives += 1
        now = kept()
        assert before <= now, f"lost: {before - now}"
        before = now
        print(f"life {lives} of {life_s:.0f} s: {len(now)} trials; {ending[:60]}", flush=True)
        assert lives <= int(kills) + 5, "the last lives were long enough"
    serving.terminate()
    serving.wait()
print(f"{lives - 1} browsers and {programs - 1} programs were killed: {len(before)} trials, each once.")
