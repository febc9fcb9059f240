"""A site and the drop that it sends trials to, as DataPipe would answer.

Usage: drop.py SITE BACK [REFUSED]. Prints its port; what is sent is a file in BACK. Of the second file of a sitting
the answer is lost, so that it is sent again; what ends in REFUSED is refused for good.
"""
import functools
import http.server
import json
import os
import sys

site, back, *refused = sys.argv[1:]


class Drop(http.server.SimpleHTTPRequestHandler):
    def do_POST(self):
        sent = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        name = os.path.join(back, os.path.basename(sent["filename"]))
        if refused and name.endswith(refused[0]):
            self.send_response(403)
            return self.end_headers()
        lost = name.endswith("_0002.jsonl") and not os.path.exists(name)
        with open(name + ".part", "w") as out:
            out.write(sent["data"])
        os.rename(name + ".part", name)
        self.send_response(500 if lost else 200 if sent["experimentID"] == "a-study" else 400)
        self.end_headers()

    def log_message(self, *words):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Drop, directory=site))
print(server.server_port, flush=True)
server.serve_forever()
