"""Opens reports of washout in headless Chromium and says what is wrong with them; needs nothing but Python and chromium."""

import argparse
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time
from decimal import Decimal

MOST_BYTES = 5_000_000
MOST_MS = 2_000
# Screenshots of docs/report.md: width, height, dark or not.
PICTURES = {"light": (1200, 1500, False), "dark": (1200, 1500, True), "phone": (390, 1400, False)}

# What must not happen is noted before anything runs; what was drawn is read after all has run.
BEFORE = """<script>window.faults = [];
window.addEventListener("error", function (e) { window.faults.push(String(e.message)); });
console.error = console.warn = function (m) { window.faults.push(String(m)); };
// The canvas is read often here.
var plain = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind) { return plain.call(this, kind, { willReadFrequently: true }); };</script>"""
AFTER = """<script>window.addEventListener("load", function () {
  var told = { faults: window.faults, ready_ms: Math.round(performance.now()), pictures: document.querySelectorAll(".picture svg").length };
  var canvas = document.getElementById("wing-canvas");
  function colours() {
    var pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data, seen = {}, opaque = 0;
    for (var i = 0; i < pixels.length; i += 4) if (pixels[i + 3] === 255) {
      opaque += 1; seen[pixels[i] + "," + pixels[i + 1] + "," + pixels[i + 2]] = true;
    }
    return [opaque, Object.keys(seen).length];
  }
  function finish() {
    var told_at = document.createElement("script");
    told_at.type = "application/json"; told_at.id = "told"; told_at.textContent = JSON.stringify(told);
    document.body.appendChild(told_at);
  }
  if (!canvas) return finish();
  told.first = colours();
  told.still_is_hidden = document.getElementById("wing-still").hidden;
  told.overflow = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  var frames = Number(canvas.getAttribute("data-frames")), fields = [];
  ["ArrowLeft", "ArrowUp", "+", "0"].forEach(function (key) {
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: key, cancelable: true }));
  });
  var lists = document.querySelectorAll("#wing-controls select");
  told.controls = lists.length;
  // Printing draws at once, so that nothing has to be waited for.
  function drawn() {
    window.dispatchEvent(new Event("beforeprint"));
    var what = canvas.getAttribute("data-drawn");
    if (fields.indexOf(what) < 0) fields.push(what);
    if (colours()[0] < 2000) window.faults.push("hardly anything drawn: " + what);
  }
  for (var list = 0; list < lists.length; list++) {
    for (var option = 0; option < 7; option++) {
      // Choosing a wing builds the lists anew.
      var at = document.querySelectorAll("#wing-controls select")[list];
      if (option >= at.options.length) break;
      at.selectedIndex = option;
      at.dispatchEvent(new Event("change"));
      drawn();
    }
  }
  told.frames = Number(canvas.getAttribute("data-frames")) - frames;
  told.fields = fields;
  finish();
});</script>"""


def chromium(page, *options):
    with tempfile.TemporaryDirectory() as profile:
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
                   "--disable-background-networking", "--virtual-time-budget=20000", f"--user-data-dir={profile}",
                   "--enable-logging=stderr", *options, page.resolve().as_uri()]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    console = [line for line in done.stderr.splitlines() if ":CONSOLE" in line]
    return done.stdout, console


def element(text, name):
    found = re.search(rf'<script[^>]*id="{name}"[^>]*>(.*?)</script>', text, re.S)
    return json.loads(found.group(1)) if found else None


def numbers(text, faults):
    """Every number shown must be that of its document, rounded to the digits shown."""
    documents, count = {}, 0
    for shown in re.finditer(r'<data value="([^"]*)" data-in="([^"]*)" data-of="([^"]*)">([^<]*)</data>', text):
        value, name, place, words = (html.unescape(part) for part in shown.groups())
        if name not in documents:
            documents[name] = element(text, name)
        at = documents[name]
        for key in place.split("/")[1:]:
            key = key.replace("~1", "/").replace("~0", "~")
            at = at[int(key)] if isinstance(at, list) else at[key]
        digits = Decimal(words)
        half = Decimal(5).scaleb(digits.as_tuple().exponent - 1)
        if float(value) != float(at) or abs(digits - Decimal(repr(float(at)))) > half * Decimal("1.0001"):
            faults.append(f"{place} of {name} is {at}, shown {words}")
        count += 1
    return count


def check(report, work):
    faults, text = [], report.read_text()
    body = re.sub(r"<script.*?</script>", "", text, flags=re.S)
    for outside in re.findall(r'\b(?:src|href)\s*=\s*"?([^">\s]*)|(@import|url\()', body):
        if outside[1] or not outside[0].startswith(("#", "data:")):
            faults.append(f"reaches out of itself: {outside}")
    if len(text.encode()) > MOST_BYTES:
        faults.append(f"{len(text.encode())} bytes")
    count = numbers(text, faults)
    if count < 20:
        faults.append(f"only {count} numbers say where they are from")
    _, console = chromium(report, "--dump-dom")
    faults += console
    tried = work / f"tried-{report.stem}.html"
    tried.write_text(text.replace("<head>", "<head>" + BEFORE, 1).replace("</body>", AFTER + "</body>", 1))
    for width in (1200, 390):
        begun = time.monotonic()
        dom, console = chromium(framed(tried, width, 900, work) if width < 500 else tried, "--dump-dom",
                                f"--window-size={max(width, 500)},900")
        took = time.monotonic() - begun
        if width < 500:
            # What is in a frame cannot be dumped from outside; no console error is what can be seen.
            faults += console
            continue
        told = element(dom, "told")
        if told is None:
            faults.append(f"{width} px: the page did not get to its end")
            continue
        faults += told["faults"]
        # A busy machine is slow now and then, not three times in a row.
        for _ in range(2):
            if told["ready_ms"] > MOST_MS:
                again = element(chromium(tried, "--dump-dom")[0], "told") or told
                told["ready_ms"] = min(told["ready_ms"], again["ready_ms"])
        if told["ready_ms"] > MOST_MS:
            faults.append(f"ready after {told['ready_ms']} ms")
        if "first" in told:
            opaque, colours = told["first"]
            if opaque < 2000 or colours < 20:
                faults.append(f"the wing is not drawn: {opaque} pixels in {colours} colours")
            if not told["still_is_hidden"] or told["frames"] < 3:
                faults.append(f"the viewer does not answer: {told}")
            if told["overflow"] > 0:
                faults.append(f"{width} px: wider than the window by {told['overflow']} px")
        print(f"{report}: {len(text.encode())} bytes, {count} numbers as in their documents, {told['pictures']} pictures, "
              f"ready after {told['ready_ms']} ms ({took:.1f} s with Chromium's start), drawn {told.get('first')}, "
              f"{told.get('fields')}")
    plain, _ = chromium(report, "--dump-dom", "--blink-settings=scriptEnabled=false")
    if "wing-data" in text and re.search(r'id="wing-still"[^>]*hidden', plain):
        faults.append("no still picture without JavaScript")
    return faults


def framed(report, width, height, work):
    """A page that shows another one as narrow as a phone; Chromium's own window has a least width."""
    page = work / f"frame-{report.stem}-{width}.html"
    page.write_text(f'<!DOCTYPE html><body style="margin:0"><iframe src="{report.resolve().as_uri()}" width="{width}" '
                    f'height="{height}" style="border:0"></iframe></body>')
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report", nargs="+", type=pathlib.Path)
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for the screenshots of the first report")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("target"))
    asked = parser.parse_args()
    faults = [f"{report}: {fault}" for report in asked.report for fault in check(report, asked.work)]
    if asked.pictures:
        for name, (width, height, is_dark) in PICTURES.items():
            picture = asked.pictures / f"report-{name}.png"
            page = asked.report[0] if width >= 500 else framed(asked.report[0], width, height, asked.work)
            scheme = f"--blink-settings=preferredColorScheme={0 if is_dark else 1}"
            chromium(page, f"--screenshot={picture.resolve()}", f"--window-size={width},{height}", scheme)
            size = picture.stat().st_size if picture.exists() else 0
            if not 10_000 < size < 300_000:
                faults.append(f"{picture}: {size} bytes")
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
