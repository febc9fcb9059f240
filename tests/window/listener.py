# SPDX-License-Identifier: MIT
"""Listens to a sink of PulseAudio as a microphone would:  listener.py DEVICE FILE

Writes "ready", then "NANOSECONDS" for each onset, by the clock that only goes forward: where it is in the
stream, by the parts of the stream that came soonest."""

import array
import subprocess
import sys
import time

RATE = 48000
QUIET = RATE // 20  # so long before an onset

device, file = sys.argv[1:]
recorder = subprocess.Popen(
    ["parec", f"--device={device}", "--format=s16le", f"--rate={RATE}", "--channels=1", "--latency-msec=5"],
    stdout=subprocess.PIPE)
offset_ns, count, last_loud = None, 0, -QUIET
with open(file, "w", buffering=1) as out:
    while True:
        part = recorder.stdout.read1(1 << 16)
        if not part:
            break
        samples = array.array("h", part[: len(part) // 2 * 2])
        came_ns = time.monotonic_ns() - (count + len(samples)) * 1_000_000_000 // RATE
        if offset_ns is None:
            print("ready", file=out)
        offset_ns = came_ns if offset_ns is None else min(offset_ns, came_ns)
        for i, sample in enumerate(samples):
            if abs(sample) > 500:
                if count + i - last_loud > QUIET:
                    print(offset_ns + (count + i) * 1_000_000_000 // RATE, file=out)
                last_loud = count + i
        count += len(samples)
