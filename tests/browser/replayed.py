"""Recordings simulated again in a browser's own WebAssembly: what replay_lines says of each.

replayed.py BUILD FOLDER BROWSER: BUILD has replay_page.js, FOLDER the recordings as lines. Ends with an error
unless every one of them has the same bits.
"""
import contextlib
import functools
import http.server
import json
import os
import shutil
import sys
import tempfile
import threading

from browsers import open_browser, see_through

PAGE = """<!doctype html>
<meta charset="utf-8">
<script src="replay_page.js"></script>
<script>
window.said = [];
const say = (line) => window.said.push(line);
const replay_all = async (names) => {
  const replay = await createReplay({print: say, printErr: say});
  for (const name of names) {
    replay.FS.writeFile(name, new Uint8Array(await (await fetch(name)).arrayBuffer()));
    replay.callMain([name]);
    replay.FS.unlink(name);
  }
  window.ended = true;
};
replay_all(NAMES).catch((error) => { window.failed = String(error); });
</script>
"""


class Server(http.server.SimpleHTTPRequestHandler):
    """Serves files, and says nothing of it."""

    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    """The folder's address."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()


def write_page(folder, build, names):
    """Beside the recordings: the page, and what was built."""
    for name in ("replay_page.js", "replay_page.wasm"):
        shutil.copy(os.path.join(build, name), folder)
    with open(os.path.join(folder, "index.html"), "w") as out:
        out.write(PAGE.replace("NAMES", json.dumps(names)))


def main():
    build, folder, program = sys.argv[1:]
    names = sorted(name for name in os.listdir(folder) if name.endswith(".lines"))
    write_page(folder, build, names)
    with tempfile.TemporaryDirectory() as own, served(folder) as link, open_browser(program, own, 640, 512) as browser:
        see_through(browser, link, 600)
        said = browser.ask("return window.said;")
    whole = [line for line in said if line.split(":")[0] in names and "the same bits" in line]
    if not names or len(whole) != len(names) or said != whole:
        sys.exit("\n".join([f"{program}: expected the same bits of {len(names)} recordings, got:", *said]))
    steps = sum(int(line.split(": ")[1].split()[0]) for line in whole)
    print(f"{program}: {len(names)} recordings, {steps} steps, the same bits")


main()
