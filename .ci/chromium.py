"""Drives a headless Chromium as a person would: keys, pointer, windows of any size, light or dark; needs nothing but Python and chromium.

It speaks the DevTools protocol over a pipe, so that no port is opened."""

import base64
import json
import os
import select
import subprocess
import tempfile
import time

# As on a machine without a graphics card: WebGL and the page are drawn by the processor.
OPTIONS = ("--headless", "--no-sandbox", "--hide-scrollbars", "--no-first-run", "--disable-background-networking", "--mute-audio",
           "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing", "--remote-debugging-pipe")

# Keys that are not a letter: code, and what the key types.
KEYS = {"Tab": (9, ""), "Enter": (13, "\r"), "Escape": (27, ""), " ": (32, " "), "End": (35, ""), "Home": (36, ""), "ArrowLeft": (37, ""),
        "ArrowUp": (38, ""), "ArrowRight": (39, ""), "ArrowDown": (40, ""), "Backspace": (8, ""), "Delete": (46, ""), "PageUp": (33, ""),
        "PageDown": (34, "")}
SHIFT, CTRL = 8, 2


class Page:
    """A page in a browser of its own."""

    def __init__(self, address, width=1280, height=800, dark=False, options=()):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_browser, self.sending = os.pipe()
        self.receiving, from_browser = os.pipe()

        def as_three_and_four():
            # Out of the way first: either of them may be 3 or 4 already.
            read, write = os.dup(to_browser), os.dup(from_browser)
            read, write = (os.dup2(read, 103, inheritable=True), os.dup2(write, 104, inheritable=True))
            os.dup2(read, 3, inheritable=True)
            os.dup2(write, 4, inheritable=True)

        self.process = subprocess.Popen(
            ["chromium", *OPTIONS, *options, f"--user-data-dir={self.profile.name}", f"--window-size={width},{height}", "about:blank"],
            preexec_fn=as_three_and_four, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer, self.count, self.session, self.faults = b"", 0, None, []
        target = self.ask("Target.createTarget", url="about:blank", browser=True)["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True, browser=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.window(width, height, dark)
        self.ask("Page.navigate", url=address)

    def window(self, width, height, dark=False, motion=True):
        """Another size of the window, another scheme of colours."""
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.ask("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "no-preference" if motion else "reduce"}])

    def ask(self, method, browser=False, **parameters):
        """A command of the protocol and its answer."""
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if not browser:
            message["sessionId"] = self.session
        os.write(self.sending, json.dumps(message).encode() + b"\0") if len(json.dumps(message)) < 60000 else self.write_all(message)
        number, until = self.count, time.monotonic() + 60
        while time.monotonic() < until:
            for got in self.messages(1.0):
                if got.get("id") == number:
                    if "error" in got:
                        raise RuntimeError(f"{method}: {got['error']}")
                    return got["result"]
        raise RuntimeError(f"{method}: no answer within a minute")

    def write_all(self, message):
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.sending, data):]

    def messages(self, seconds):
        """What the browser says; errors of the page are kept."""
        ready, _, _ = select.select([self.receiving], [], [], seconds)
        if ready:
            read = os.read(self.receiving, 1 << 20)
            if not read:
                raise RuntimeError("the browser ended")
            self.buffer += read
        *whole, self.buffer = self.buffer.split(b"\0")
        for one in whole:
            got = json.loads(one)
            self.note(got)
            yield got

    def note(self, got):
        method, own = got.get("method"), got.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = own["exceptionDetails"]
            self.faults.append("exception: " + details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and own["type"] in ("error", "warning", "assert"):
            self.faults.append("console: " + " ".join(str(one.get("value", one.get("description"))) for one in own["args"]))
        elif method == "Log.entryAdded" and own["entry"]["level"] in ("error", "warning"):
            entry = own["entry"]
            # A refusal of the program is an answer, not a fault; the report reads pixels for nobody but the tests.
            if "status of 422" not in entry["text"] and "ReadPixels" not in entry["text"]:
                self.faults.append(f"{entry['source']}: {entry['text']} {entry.get('url', '')}")

    def run(self, script):
        """The value of an expression in the page, waited for."""
        got = self.ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in got:
            raise RuntimeError(f"{script}: {got['exceptionDetails']}")
        return got["result"].get("value")

    def until(self, script, what, seconds=60):
        """Waits until an expression is true."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = self.run(script)
            if value:
                return value
            time.sleep(0.05)
        raise RuntimeError(f"waited {seconds} s in vain: {what}")

    def press(self, key, modifiers=0):
        """A key pressed and released."""
        code, text = KEYS[key] if key in KEYS else (ord(key.upper()) if key.isalnum() else 0, key)
        if modifiers & CTRL:
            text = ""
        own = {"key": key, "windowsVirtualKeyCode": code, "modifiers": modifiers}
        self.ask("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", text=text, **own)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **own)

    def type(self, text):
        """Text typed into what has the focus."""
        self.ask("Input.insertText", text=text)

    def click(self, x, y):
        """The mouse pressed and released."""
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def drag(self, start, end, steps=8):
        """The mouse pressed, moved and released."""
        self.ask("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left", clickCount=1)
        for k in range(1, steps + 1):
            at = [start[i] + (end[i] - start[i]) * k / steps for i in range(2)]
            self.ask("Input.dispatchMouseEvent", type="mouseMoved", x=at[0], y=at[1], button="left", buttons=1)
        self.ask("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", clickCount=1)

    def picture(self, file, whole=False):
        """A screenshot, of the window or of the whole page."""
        got = self.ask("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        file.write_bytes(base64.b64decode(got["data"]))

    def close(self):
        """Ends the browser."""
        try:
            self.ask("Browser.close", browser=True)
            self.process.wait(10)
        except (RuntimeError, BrokenPipeError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.sending)
        os.close(self.receiving)
        self.profile.cleanup()
