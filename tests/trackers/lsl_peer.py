#!/usr/bin/env python3
"""The other end of the Lab Streaming Layer, by the true liblsl.

lsl_peer.py LIBRARY send       a stream "gaze" of four channels: sample n, taken at n * 5 ms of
                               CLOCK_MONOTONIC, on a path that follows from n alone; of 100 samples one is
                               not valid and one is off the screen
lsl_peer.py LIBRARY record NAME FILE    writes "SECONDS TEXT" for each marker of the stream of that name
"""
import ctypes
import sys
import time

STEP_S = 0.005
TEXT, DOUBLE = 3, 2
handle, number, text = ctypes.c_void_p, ctypes.c_double, ctypes.c_char_p


def liblsl(path):
    library = ctypes.CDLL(path)
    for name, result, arguments in [
        ("lsl_create_streaminfo", handle, [text, text, ctypes.c_int, number, ctypes.c_int, text]),
        ("lsl_create_outlet", handle, [handle, ctypes.c_int, ctypes.c_int]),
        ("lsl_push_sample_dtp", ctypes.c_int, [handle, ctypes.POINTER(number), number, ctypes.c_int]),
        ("lsl_resolve_byprop", ctypes.c_int, [ctypes.POINTER(handle), ctypes.c_uint, text, text, ctypes.c_int, number]),
        ("lsl_create_inlet", handle, [handle, ctypes.c_int, ctypes.c_int, ctypes.c_int]),
        ("lsl_pull_sample_str", number, [handle, ctypes.POINTER(text), ctypes.c_int, number, ctypes.POINTER(ctypes.c_int)]),
    ]:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def send(lsl):
    outlet = lsl.lsl_create_outlet(lsl.lsl_create_streaminfo(b"gaze", b"Gaze", 4, 200.0, DOUBLE, b"peer"), 0, 360)
    n = int(time.monotonic() / STEP_S) + 1
    while True:
        time.sleep(max(0, n * STEP_S - time.monotonic()))
        x = 1.25 if n % 100 == 8 else (n % 200) / 200
        values = (number * 4)(x, 1 - (n // 200 % 200) / 200, n, int(n % 100 != 7))
        lsl.lsl_push_sample_dtp(outlet, values, n * STEP_S, 1)
        n += 1


def record(lsl, name, file):
    found = (handle * 1)()
    while lsl.lsl_resolve_byprop(found, 1, b"name", name.encode(), 1, 1.0) < 1:
        pass
    inlet = lsl.lsl_create_inlet(found[0], 360, 0, 1)
    with open(file, "w", buffering=1) as out:
        while True:
            came, error = (text * 1)(), ctypes.c_int()
            seconds = lsl.lsl_pull_sample_str(inlet, came, 1, 1.0, ctypes.byref(error))
            if seconds:
                print(f"{seconds:.9f} {came[0].decode()}", file=out)


library = liblsl(sys.argv[1])
send(library) if sys.argv[2] == "send" else record(library, *sys.argv[3:])
