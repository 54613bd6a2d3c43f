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
# Screenshots of docs/report.md: which report, width, height, dark or not, what is done before.
ALONE = 'document.querySelectorAll("header, nav, section:not(#wing), #wing h2").forEach(function (own) { own.remove(); });'
CHOOSE = """function choose(label, value) {
  var own = Array.from(document.querySelectorAll("#wing-controls select")).filter(function (list) {
    return list.parentNode.textContent.indexOf(label) === 0; })[0];
  own.value = value; own.dispatchEvent(new Event("change"));
}
function press(view) { document.querySelectorAll("#wing-views button")[view].click(); window.dispatchEvent(new Event("beforeprint")); }
"""
HOVER = """var canvas = document.getElementById("wing-canvas"), room = canvas.getBoundingClientRect();
canvas.dispatchEvent(new PointerEvent("pointermove", { clientX: room.left + %s * room.width, clientY: room.top + %s * room.height,
  pointerId: 1, pointerType: "mouse" }));"""
PICTURES = {
    "light": (0, 1280, 1500, False, ""), "dark": (0, 1280, 1500, True, ""), "phone": (0, 390, 1500, False, ""),
    "measured": (0, 1280, 720, False, ALONE + CHOOSE + 'choose("Ghost", "measured:0"); press(1);' + HOVER % (0.62, 0.45)),
    "stroke": (1, 1280, 720, False, ALONE + CHOOSE + 'choose("Show", "stroke"); press(0);'),
}

# WebGL without a graphics card, and a browser that has none.
WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_WEBGL = ("--disable-gpu", "--disable-3d-apis")

# What must not happen is noted before anything runs; what was drawn is read after all has run.
BEFORE = """<script>window.faults = [];
window.addEventListener("error", function (e) { window.faults.push(String(e.message)); });
console.error = console.warn = function (m) { window.faults.push(String(m)); };
// Chromium's time runs ahead of its frames here, the more so on a busy machine: what waits for a frame waits for time instead.
window.requestAnimationFrame = function (f) { return setTimeout(function () { f(performance.now()); }, 16); };</script>"""
AFTER = "<script>" + (pathlib.Path(__file__).parent / "report_probe.js").read_text() + "</script>"


def chromium(page, *options, webgl=True):
    with tempfile.TemporaryDirectory() as profile:
        command = ["chromium", "--headless", "--no-sandbox", "--hide-scrollbars", "--no-first-run",
                   "--disable-background-networking", "--virtual-time-budget=20000", f"--user-data-dir={profile}",
                   "--enable-logging=stderr", *(WEBGL if webgl else NO_WEBGL), *options, page.resolve().as_uri()]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    # Reading the picture back is slow on a graphics card; nobody but this script does it.
    console = [line for line in done.stderr.splitlines() if ":CONSOLE" in line and "ReadPixels" not in line]
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


def check_values(text, told, faults):
    """What is said under the cursor is what the document, and where it says nothing the data of the wing, has there."""
    wing, summary, count = element(text, "wing-data")["wings"][0], element(text, "summary") or {}, 0
    for work in told["works"]:
        is_stroke, said = work["mode"] == "stroke", work["values"]
        phases = [wing["stroke"][0]] * len(work["colours"]) if is_stroke else []
        if is_stroke:
            # then one for each place of the slider that was tried, in the first colour
            rows = [int(re.search(r"/stroke/phases/(\d+)/phase_deg", html_).group(1)) for html_ in work["told"]]
            phases += [next(own for own in wing["stroke"] if own["row"] == row) for row in rows]
        names = work["colours"] + [work["colours"][0]] * (len(said) - len(work["colours"]))
        for index, (name, found) in enumerate(zip(names, said)):
            # The loaded wing fills the picture; over the stroke it is a small part of it, and may show its edge.
            if len(found) < (1 if is_stroke else 20):
                if not is_stroke:
                    faults.append(f"{work['mode']}, {name}: a value at {len(found)} places only")
                continue
            phase = phases[index] if is_stroke else None
            for value_words, r_words in found:
                value, r_mm = taken_apart(value_words, name, r_words, faults)
                if value is None:
                    continue
                count += 1
                if not could_be(wing, phase, name, value, r_mm):
                    faults.append(f"{work['mode']}: {value_words} at {r_words} is nowhere in the data")
                if name == "twist":
                    check_twist(summary, phase, value, r_mm, faults)
    return count


def taken_apart(value_words, name, r_words, faults):
    unit = {"twist": "deg", "pressure": "Pa"}.get(name, "N/m")
    value = re.fullmatch(rf"{name} (\S+) {unit}", value_words)
    r_mm = re.fullmatch(r"r = (-?[\d.]+) mm", r_words)
    if not value or not r_mm:
        faults.append(f"under the cursor: {value_words}, {r_words}")
        return None, None
    return float(value.group(1).replace("\u2212", "-")), float(r_mm.group(1))


def could_be(wing, phase, name, value, r_mm):
    """Whether a triangle that reaches over this place along the span has such a value."""
    own = None if phase else next(field for field in wing["fields"] if field["name"] == name)
    values = phase[name] if phase else own["values"]
    is_on_points = phase is not None or own["on"] == "points"
    slack = 0.06 + 0.0006 * abs(value)
    for t in range(0, len(wing["triangles"]), 3):
        nodes = wing["triangles"][t:t + 3]
        places = [wing["rest"][3 * node] / 1000 for node in nodes]
        if not min(places) - 0.06 <= r_mm <= max(places) + 0.06:
            continue
        here = [values[node] for node in nodes] if is_on_points else [values[t // 3]]
        if min(here) - slack * is_on_points - 0.0006 * abs(value) <= value <= max(here) + slack * is_on_points + 0.0006 * abs(value):
            return True
    return False


def check_twist(summary, phase, value, r_mm, faults):
    """Against the document: along the span as loaded, at the stations at a phase of the stroke; not at the base, which is read where
    the rod is clamped, while the film beside it is free."""
    if summary.get("design", {}).get("observation", {}).get("instrument") != "chord_rotation":
        return
    if phase is not None:
        tip = summary["tip"]
        row = summary["stroke"]["phases"][phase["row"]]
        own = [one for one in summary["stroke"]["profile"] if one["phase_deg"] == row["phase_deg"]]
        stations = [(one["r_mm"], one["twist_deg"]) for one in own]
        near = [one for one in stations if one[0] > 1 and abs(one[0] - r_mm) < 0.2]
        if near and abs(near[0][1] - value) > 1.0 + 0.1 * abs(value):
            faults.append(f"phase {row['phase_deg']}: twist {value} at {r_mm} mm, in the document {near[0]} (tip {tip['r_mm']})")
        return
    rows = [(row["r_mm"], row["twist_deg"]) for row in summary["along_span"] if row["bound"] == "none"]
    for (a, low), (b, high) in zip(rows, rows[1:]):
        if a > 1 and a <= r_mm <= b:
            between = low + (high - low) * (r_mm - a) / (b - a)
            if abs(between - value) > 0.15 + 0.2 * abs(high - low):
                faults.append(f"twist {value} at {r_mm} mm, in the document {between:.3f}")


def check_told(told, where, pen, faults):
    """What the probe in the page has seen."""
    if told is None:
        faults.append(f"{where}: the page did not get to its end")
        return
    faults += [f"{where}: {fault}" for fault in told["faults"]]
    if told["overflow"] > 0:
        faults.append(f"{where}: wider than the window by {told['overflow']} px")
    if "pen" not in told:
        return
    if told["pen"] != pen or not told["still_is_hidden"]:
        faults.append(f"{where}: drawn by {told['pen']}, not by {pen}")
    if not (told.get("has_play") and told.get("is_still") and told.get("is_moved")):
        faults.append(f"{where}: it does not play, or does so by itself")


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
    tried = work / f"tried-{report.parent.name}-{report.stem}.html"
    tried.write_text(text.replace("<head>", "<head>" + BEFORE, 1).replace("</body>", AFTER + "</body>", 1))
    begun = time.monotonic()
    dom, console = chromium(tried, "--dump-dom", "--window-size=1280,900")
    took = time.monotonic() - begun
    told = element(dom, "told")
    check_told(told, "1280 px", "webgl", faults)
    faults += console
    if told is None:
        return faults
    # A busy machine is slow now and then, not three times in a row.
    for _ in range(2):
        if told["ready_ms"] > MOST_MS:
            again = element(chromium(tried, "--dump-dom")[0], "told") or told
            told["ready_ms"] = min(told["ready_ms"], again["ready_ms"])
    if told["ready_ms"] > MOST_MS:
        faults.append(f"ready after {told['ready_ms']} ms")
    values = check_values(text, told, faults) if "works" in told else 0
    for one in told.get("works", []):
        # Numbers that come and go with the slider stand in their documents too.
        numbers(text + "".join(one["told"]), faults)
    dom, console = chromium(framed(tried, 390, 900, work), "--dump-dom", "--window-size=500,900")
    check_told(element(dom, "told"), "390 px", "webgl", faults)
    faults += console
    if "works" in told:
        dom, _ = chromium(tried, "--dump-dom", "--window-size=1280,900", webgl=False)
        check_told(element(dom, "told"), "without WebGL", "canvas", faults)
        dom, _ = chromium(tried, "--dump-dom", "--force-prefers-reduced-motion")
        if (element(dom, "told") or {}).get("has_play") is not False:
            faults.append("it can be played where no motion is wanted")
    shown = [f"{one['mode']}: {', '.join(one['colours'])}; ghosts {', '.join(one['ghosts'])}" for one in told.get("works", [])]
    print(f"{report}: {len(text.encode())} bytes, {count} numbers as in their documents, {values} values under the cursor, "
          f"{told['pictures']} pictures, ready after {told['ready_ms']} ms ({took:.1f} s with Chromium's start); {'. '.join(shown)}")
    plain, _ = chromium(report, "--dump-dom", "--blink-settings=scriptEnabled=false")
    if "wing-data" in text and re.search(r'id="wing-still"[^>]*hidden', plain):
        faults.append("no still picture without JavaScript")
    return faults


def framed(report, width, height, work):
    """A page that shows another one as narrow as a phone; Chromium's own window has a least width."""
    page = work / f"frame-{report.stem}-{width}.html"
    page.write_text('<!DOCTYPE html><script>window.addEventListener("message", function (e) {'
                    'var told = document.createElement("script"); told.type = "application/json"; told.id = "told";'
                    'told.textContent = e.data.replace(/</g, "\\\\u003c"); document.body.appendChild(told); });</script>'
                    f'<body style="margin:0"><iframe src="{report.resolve().as_uri()}" width="{width}" '
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
        for name, (index, width, height, is_dark, before) in PICTURES.items():
            if index >= len(asked.report):
                continue
            picture, page = asked.pictures / f"report-{name}.png", asked.report[index]
            if before:
                page = asked.work / f"picture-{name}.html"
                script = f'<script>window.addEventListener("load", function () {{ {before} }});</script></body>'
                page.write_text(asked.report[index].read_text().replace("</body>", script, 1))
            page = page if width >= 500 else framed(page, width, height, asked.work)
            scheme = f"--blink-settings=preferredColorScheme={0 if is_dark else 1}"
            chromium(page, f"--screenshot={picture.resolve()}", f"--window-size={max(width, 390)},{height}", scheme)
            size = picture.stat().st_size if picture.exists() else 0
            if not 10_000 < size < 300_000:
                faults.append(f"{picture}: {size} bytes")
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
