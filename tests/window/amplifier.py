# SPDX-License-Identifier: MIT
"""Reads codes from a serial port as an amplifier would:  amplifier.py PORT FILE

Writes "CODE NANOSECONDS" for each byte, by the clock that only goes forward."""

import sys
import time

import serial

with serial.Serial(sys.argv[1], 115200) as port, open(sys.argv[2], "w", buffering=1) as file:
    print("ready", file=file)
    while True:
        for code in port.read(1):
            print(code, time.monotonic_ns(), file=file)
