"""Recordings simulated again in a browser's own WebAssembly: what replay_lines says of each.

replayed.py BUILD FOLDER BROWSER: BUILD has replay_page.js, FOLDER the recordings as lines. Ends with an error
unless every one of them has the same bits.
"""
import contextlib
import functools
import http.server
import json
import os
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
    """The page, what was built, and the recordings."""

    def __init__(self, build, page, *arguments, **more):
        self.build, self.page = build, page
        super().__init__(*arguments, **more)

    def translate_path(self, path):
        name = os.path.basename(path)
        return os.path.join(self.build, name) if name.startswith("replay_page.") else super().translate_path(path)

    def do_GET(self):
        if self.path != "/":
            return super().do_GET()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(self.page.encode())

    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(build, folder, names):
    """The address of the page."""
    page = PAGE.replace("NAMES", json.dumps(names))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, build, page, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()


def main():
    build, folder, program = sys.argv[1:]
    names = sorted(name for name in os.listdir(folder) if name.endswith(".lines"))
    with tempfile.TemporaryDirectory() as own, served(build, folder, names) as link, \
            open_browser(program, own, 640, 512) as browser:
        see_through(browser, link, 600)
        said = browser.ask("return window.said;")
    whole = [line for line in said if line.split(":")[0] in names and "the same bits" in line]
    if not names or len(whole) != len(names) or said != whole:
        sys.exit("\n".join([f"{program}: expected the same bits of {len(names)} recordings, got:", *said]))
    steps = sum(int(line.split(": ")[1].split()[0]) for line in whole)
    print(f"{program}: {len(names)} recordings, {steps} steps, the same bits")


main()
