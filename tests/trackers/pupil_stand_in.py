#!/usr/bin/env python3
"""Stands in for Pupil Capture: Pupil Remote and what it publishes, as Pupil's own clients expect.

pupil_stand_in.py PORT [SHIFT_S [drops]]: sample n is taken at n * 5 ms of CLOCK_MONOTONIC, on a path that
follows from n alone, so that whoever reads it knows when and where it was; the tracker's clock is
SHIFT_S ahead. Of 100 samples one is unsure and one is off the surface. Samples come six at a time,
as those of a frame of the world camera do, among gaze in its image and on another surface. It says "heard"
when somebody asks it something for the first time. With "drops" it goes for 300 ms whenever somebody has
asked it something and 150 ms have passed; each tenth time it comes back at another port.
"""
import sys
import time

import msgpack
import zmq

STEP_S = 0.005


def gaze(n, shift_s):
    return {
        "topic": "gaze.3d.0._on_surface",
        "norm_pos": [(n % 200) / 200, (n // 200 % 200) / 200],
        "confidence": 0.5 if n % 100 == 7 else 0.99,
        "on_surf": n % 100 != 8,
        "base_data": ["gaze.3d.0.", n * STEP_S + shift_s],
        "timestamp": n * STEP_S + shift_s,
    }


def surface(name, gazes):
    return {
        "topic": "surfaces." + name,
        "name": name,
        "surf_to_img_trans": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        "gaze_on_surfaces": gazes,
        "fixations_on_surfaces": [],
        "timestamp": gazes[-1]["timestamp"],
    }


def bound(context, kind, port):
    """A socket at the port, which the one before may hold for a moment longer; 0: at any."""
    made = context.socket(kind)
    made.linger = 0
    while True:
        try:
            made.bind(f"tcp://127.0.0.1:{port or '*'}")
            return made
        except zmq.ZMQError:
            time.sleep(0.01)


def port_of(published):
    return int(published.getsockopt_string(zmq.LAST_ENDPOINT).rsplit(":", 1)[1])


def main():
    port, shift_s = int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.0
    goes = "drops" in sys.argv[3:]
    context = zmq.Context()
    remote = bound(context, zmq.REP, port)
    published = bound(context, zmq.PUB, 0)
    published_port = port_of(published)
    drops, heard_s = 0, None

    def publish(topic, payload):
        published.send_string(topic, flags=zmq.SNDMORE)
        published.send(msgpack.packb(payload, use_bin_type=True))

    next_n = int(time.monotonic() / STEP_S) + 1
    gazes = []
    while True:
        wait_ms = max(0, (next_n * STEP_S - time.monotonic()) * 1000)
        if remote.poll(wait_ms):
            asked = remote.recv_string()
            if asked == "SUB_PORT":
                remote.send_string(str(published_port))
            elif asked == "t":
                remote.send_string(repr(time.monotonic() + shift_s))
            else:
                remote.send_string("Unknown command.")
            if heard_s is None:
                print("heard", flush=True)
                heard_s = time.monotonic()
        if goes and heard_s and time.monotonic() - heard_s > 0.15:
            remote.close()
            published.close()
            time.sleep(0.3)
            drops, heard_s, gazes = drops + 1, None, []
            remote = bound(context, zmq.REP, port)
            published = bound(context, zmq.PUB, 0 if drops % 10 == 0 else published_port)
            published_port = port_of(published)
            next_n = int(time.monotonic() / STEP_S) + 1
        while next_n * STEP_S <= time.monotonic():
            gazes.append(gaze(next_n, shift_s))
            next_n += 1
        if len(gazes) >= 6:
            publish("gaze.3d.0.", gazes[-1])
            publish("surfaces.screen left", surface("screen left", [gaze(0, shift_s)]))
            publish("surfaces.screen", surface("screen", gazes))
            gazes = []


main()
