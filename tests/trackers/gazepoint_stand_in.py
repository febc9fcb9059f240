#!/usr/bin/env python3
"""Stands in for Gazepoint Control: an Open Gaze server for one client after the other.

gazepoint_stand_in.py PORT [SHIFT_S [drops]]: sample n is taken at n * 5 ms of CLOCK_MONOTONIC, on a path that
follows from n alone; the tracker's clock is SHIFT_S ahead. Of 100 samples one is not valid and one is
off the screen. Every SET is answered, as Gazepoint does; no record is sent before the client asks for
it, and then it comes as TCP may cut it: a line in two parts, two lines at once, an answer or a line of
a calibration between them. With "drops" it closes the connection after 60 samples, and takes none for
300 ms. It says "heard" when a client has asked for records, and "late" where the machine let it sleep
50 ms too long.
"""
import socket
import sys
import time

STEP_S = 0.005


def record(n, shift_s):
    x, y = (n % 200) / 200, (n // 200 % 200) / 200
    if n % 100 == 8:
        x = 1.25
    valid = int(n % 100 != 7)
    return (f'<REC TIME="{n * STEP_S + shift_s:.5f}" FPOGX="0.11111" FPOGY="0.22222" FPOGV="1" '
            f'BPOGX="{x:.5f}" BPOGY="{1 - y:.5f}" BPOGV="{valid}" />\r\n')


def serve(client, shift_s, most):
    asked = b""
    client.settimeout(5)
    while b'ENABLE_SEND_DATA" STATE="1"' not in asked:
        came = client.recv(4096)
        if not came:
            return
        *lines, _ = (asked.rpartition(b"\n")[2] + came).split(b"\n")
        asked += came
        for line in lines:
            client.sendall(line.replace(b"<SET", b"<ACK") + b"\n")
    for needed in (b"ENABLE_SEND_TIME", b"ENABLE_SEND_POG_BEST"):
        if needed not in asked:
            return
    print("heard", flush=True)
    first = n = int(time.monotonic() / STEP_S) + 1
    held = ""
    while most is None or n < first + most:
        time.sleep(max(0, n * STEP_S - time.monotonic()))
        if time.monotonic() - n * STEP_S > 0.05:
            print("late", flush=True)
        text = held + record(n, shift_s)
        if n % 40 == 0:
            text += '<CAL ID="CALIB_START_PT" PT="1" CALX="0.5" CALY="0.5" />\r\n'
        # Every tenth line is cut, and ends with the next.
        cut = len(text) - 30 if n % 10 == 3 else len(text)
        held = text[cut:]
        client.sendall(text[:cut].encode())
        n += 1


def main():
    port, shift_s = int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.0
    goes = "drops" in sys.argv[3:]
    listening = socket.socket()
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    listening.bind(("127.0.0.1", port))
    listening.listen()
    while True:
        client, _ = listening.accept()
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            serve(client, shift_s, 60 if goes else None)
        except OSError:
            pass
        client.close()
        time.sleep(0.3 if goes else 0)


main()
