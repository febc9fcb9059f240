"""A browser without a window that is given real keys and a real mouse, and asked what its page says.

    with open_browser("chromium", folder, 960, 720) as browser:
        browser.go(link)
        browser.press("y")

Chromium is spoken to through its DevTools pipe, Firefox through Marionette: neither needs a driver of
its own to be installed.
"""
import base64
import contextlib
import fcntl
import json
import os
import signal
import socket
import subprocess
import time

# Of each key: its name in a page, the code of its place, its number, what it types, its WebDriver letter.
KEYS = {
    "space": (" ", "Space", 32, " ", " "),
    "enter": ("Enter", "Enter", 13, "\r", "\ue007"),
    "escape": ("Escape", "Escape", 27, "", "\ue00c"),
    "tab": ("Tab", "Tab", 9, "", "\ue004"),
    "left": ("ArrowLeft", "ArrowLeft", 37, "", "\ue012"),
    "right": ("ArrowRight", "ArrowRight", 39, "", "\ue014"),
    "up": ("ArrowUp", "ArrowUp", 38, "", "\ue013"),
    "down": ("ArrowDown", "ArrowDown", 40, "", "\ue015"),
    "page down": ("PageDown", "PageDown", 34, "", "\ue00f"),
}


def key_of(name):
    """The five things of a key; a letter or a digit is its own name."""
    if name in KEYS:
        return KEYS[name]
    code = ("Digit" if name.isdigit() else "Key") + name.upper()
    return name, code, ord(name.upper()), name, name


class Chromium:
    """Speaks the DevTools protocol through two pipes, a message between zeros."""

    FLAGS = ["--headless=new", "--no-sandbox", "--no-first-run", "--disable-dev-shm-usage", "--use-gl=angle",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--remote-debugging-pipe"]

    def __init__(self, program, folder, width, height):
        ours = [os.pipe(), os.pipe()]
        theirs = [fcntl.fcntl(end, fcntl.F_DUPFD, 20) for end in (ours[0][0], ours[1][1])]

        def take_pipes():
            os.dup2(theirs[0], 3)
            os.dup2(theirs[1], 4)

        log = open(os.path.join(folder, "browser.log"), "w")
        self.process = subprocess.Popen(
            [program, *self.FLAGS, f"--user-data-dir={folder}/profile", "about:blank"], stdout=log, stderr=log,
            close_fds=False, preexec_fn=take_pipes, start_new_session=True)
        self.out, self.into = os.fdopen(ours[0][1], "wb", 0), os.fdopen(ours[1][0], "rb")
        for end in (ours[0][0], ours[1][1], *theirs):
            os.close(end)
        self.number, self.session, self.rest, self.notices = 0, None, b"", []
        pages = [target for target in self.call("Target.getTargets")["targetInfos"] if target["type"] == "page"]
        self.session = self.call("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setFocusEmulationEnabled", enabled=True)
        self.call("Page.enable")
        self.call("Log.enable")
        self.call("Network.enable", maxPostDataSize=1 << 26)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        self.out.write(json.dumps(message).encode() + b"\0")
        while True:
            answer = self.next_message()
            if answer.get("method", "").startswith(("Network.", "Log.")):
                self.notices.append(answer)
            elif answer.get("method") == "Page.javascriptDialogOpening":
                self.number += 1
                self.out.write(json.dumps({"id": self.number, "method": "Page.handleJavaScriptDialog",
                                           "params": {"accept": True}, "sessionId": self.session}).encode() + b"\0")
            if answer.get("id") == message["id"]:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def next_message(self):
        while b"\0" not in self.rest:
            some = self.into.read1(1 << 16)
            if not some:
                raise RuntimeError("the browser is gone")
            self.rest += some
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def heard(self):
        """What it has told of requests and of its log; of one that was killed, to the last word."""
        if self.process.poll() is not None:
            with contextlib.suppress(RuntimeError):
                while True:
                    self.notices.append(self.next_message())
        return self.notices

    def asked(self):
        """The links that its pages have asked for, or would have if they had been let."""
        return [message["params"]["request"]["url"] for message in self.heard()
                if message["method"] == "Network.requestWillBeSent"]

    def complaints(self):
        """What it wrote in its log of pages that did what their policy forbids."""
        entries = [message["params"]["entry"] for message in self.heard() if message["method"] == "Log.entryAdded"]
        return [entry["text"] for entry in entries if "Content Security Policy" in entry["text"]]

    def go(self, link):
        self.call("Page.navigate", url=link)

    def ask(self, script):
        result = self.call("Runtime.evaluate", expression=f"(() => {{ {script} }})()", returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"]["exception"]["description"])
        return result["result"].get("value")

    def press(self, name):
        key, code, number, text, _ = key_of(name)
        facts = {"key": key, "code": code, "windowsVirtualKeyCode": number}
        self.call("Input.dispatchKeyEvent", type="keyDown", **facts, **({"text": text} if text else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", **facts)

    def type(self, words):
        self.call("Input.insertText", text=words)

    def move(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def click(self, x, y):
        self.move(x, y)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def end(self):
        pass

    def picture(self, file):
        with open(file, "wb") as out:
            out.write(base64.b64decode(self.call("Page.captureScreenshot")["data"]))


def open_screen(width, height, log):
    """A screen that nobody sees; it and its name."""
    told, tell = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(tell), "-screen", "0", f"{width}x{height}x24"], stdout=log,
                              stderr=log, pass_fds=[tell])
    os.close(tell)
    with os.fdopen(told) as number:
        return screen, ":" + number.readline().strip()


class Firefox:
    """Speaks Marionette: WebDriver's own commands over a socket, each message after its length. It fills a
    screen of its own: without any, it has no WebGL."""

    PREFERENCES = {"marionette.port": 0, "browser.shell.checkDefaultBrowser": False,
                   "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False,
                   "toolkit.cosmeticAnimations.enabled": False, "browser.aboutwelcome.enabled": False,
                   "full-screen-api.warning.timeout": 0}

    # Notes requests of pages, not the browser's own, and complaints of a page's policy.
    LISTEN = """
    window.asked = [];
    window.complaints = [];
    window.listening = {
      observe(subject) {
        if (subject instanceof Ci.nsIScriptError) {
          if (subject.category.startsWith('CSP')) window.complaints.push(subject.errorMessage);
        } else if (subject instanceof Ci.nsIHttpChannel && subject.loadInfo.loadingPrincipal?.isContentPrincipal) {
          window.asked.push(subject.URI.spec);
        }
      },
    };
    Services.obs.addObserver(window.listening, 'http-on-modify-request');
    Services.console.registerListener(window.listening);"""

    def __init__(self, program, folder, width, height):
        profile = os.path.join(folder, "profile")
        os.makedirs(profile, exist_ok=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        with open(os.path.join(profile, "user.js"), "w") as out:
            for name, value in {**self.PREFERENCES, "marionette.port": port}.items():
                out.write(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n")
        log = open(os.path.join(folder, "browser.log"), "w")
        self.screen, display = open_screen(width, height, log)
        self.process = subprocess.Popen(
            [program, "--no-remote", "--kiosk", "--width", str(width), "--height", str(height), "--marionette",
             "--remote-allow-system-access", "--profile", profile], stdout=log, stderr=log, start_new_session=True,
            env={**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"})
        self.number = 0
        self.socket = self.connect(port)
        self.into = self.socket.makefile("rb")
        self.next_message()
        self.call("WebDriver:NewSession", capabilities={"alwaysMatch": {"unhandledPromptBehavior": "accept"}})
        self.ask_browser(self.LISTEN)

    def connect(self, port):
        for _ in range(300):
            with contextlib.suppress(ConnectionRefusedError):
                return socket.create_connection(("127.0.0.1", port))
            time.sleep(0.2)
        raise RuntimeError("the browser does not listen")

    def call(self, method, **parameters):
        self.number += 1
        words = json.dumps([0, self.number, method, parameters]).encode()
        self.socket.sendall(str(len(words)).encode() + b":" + words)
        _, _, error, result = self.next_message()
        if error:
            raise RuntimeError(f"{method}: {error['message']}")
        return result

    def next_message(self):
        length = b""
        while not length.endswith(b":"):
            byte = self.into.read(1)
            if not byte:
                raise RuntimeError("the browser is gone")
            length += byte
        return json.loads(self.into.read(int(length[:-1])))

    def go(self, link):
        self.call("WebDriver:Navigate", url=link)

    def ask(self, script):
        return self.call("WebDriver:ExecuteScript", script=script, args=[])["value"]

    def ask_browser(self, script):
        """Runs a script with the rights of the browser itself."""
        self.call("Marionette:SetContext", value="chrome")
        try:
            return self.ask(script)
        finally:
            self.call("Marionette:SetContext", value="content")

    def asked(self):
        return self.ask_browser("return window.asked;")

    def complaints(self):
        return self.ask_browser("return window.complaints;")

    def act(self, kind, actions, **more):
        self.call("WebDriver:PerformActions", actions=[{"type": kind, "id": kind, "actions": actions, **more}])

    def press(self, name):
        letter = key_of(name)[4]
        self.act("key", [{"type": "keyDown", "value": letter}, {"type": "keyUp", "value": letter}])

    def type(self, words):
        self.act("key", [{"type": kind, "value": letter} for letter in words for kind in ("keyDown", "keyUp")])

    def move(self, x, y):
        self.act("pointer", [{"type": "pointerMove", "x": round(x), "y": round(y)}])

    def click(self, x, y):
        self.act("pointer", [{"type": "pointerMove", "x": round(x), "y": round(y)},
                             {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}])

    def end(self):
        self.screen.terminate()
        self.screen.wait()

    def picture(self, file):
        with open(file, "wb") as out:
            out.write(base64.b64decode(self.call("WebDriver:TakeScreenshot", full=False)["value"]))


@contextlib.contextmanager
def open_browser(program, folder, width, height):
    """A browser with a page of so many pixels; `folder` gets its profile and its log. Ended afterwards."""
    os.makedirs(folder, exist_ok=True)
    browser = (Firefox if "firefox" in os.path.basename(program) else Chromium)(program, folder, width, height)
    try:
        yield browser
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(browser.process.pid, signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            browser.process.wait(10)
        browser.end()


def see_through(browser, link, seconds):
    """Opens a page that sets `ended` when it is done, or `failed` to what went wrong, and waits for it."""
    browser.go(link)
    for _ in range(5 * seconds):
        time.sleep(0.2)
        failed = browser.ask("return window.failed;")
        if failed:
            raise RuntimeError(f"{link}: {failed}")
        if browser.ask("return window.ended;"):
            return
    raise RuntimeError(f"{link}: did not end in {seconds} seconds")
