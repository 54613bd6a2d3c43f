"""Works the page on which frames of a video are marked, in headless Chromium, by pointer and by keyboard alone."""

import argparse
import csv
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import urllib.request
import zlib

from chromium import SHIFT, Page

HERE = pathlib.Path(__file__).parent
PROBE = (HERE / "live_probe.js").read_text()
ROOT = HERE.parent.resolve()
WIDE, TALL = 900, 480


def rows():
    """The marks of the example."""
    lines = (ROOT / "examples/video-marks.csv").read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def stations():
    return sorted({float(row["r_mm"]) for row in rows()})


def clicks(frame, mark, r_mm):
    return [(float(row["x_px"]), float(row["y_px"])) for row in rows()
            if (row["frame"], row["mark"]) == (frame, mark) and float(row["r_mm"]) == r_mm]


def picture(frame):
    """A frame as a PNG: the wing between the marks of the example, bright on dark."""
    corners = [[clicks(frame, mark, r)[0] for r in stations()] for mark in ("leading", "trailing")]

    def edge(points, x):
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            if x0 <= x <= x1:
                return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
        return None

    bounds = [[edge(points, x) for points in corners] for x in range(WIDE)]
    lines = []
    for y in range(TALL):
        line = bytearray(b"\0")
        for top, bottom in bounds:
            inside = top is not None and bottom is not None and top <= y <= bottom
            on_rod = inside and y - top < 4
            line += bytes((40, 46, 52) if not inside else (90, 96, 104) if on_rod else (206, 202, 190))
        lines.append(bytes(line))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", WIDE, TALL, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"".join(lines))) + chunk(b"IEND", b"")


class Frames:
    """Two frames, served and opened."""

    def __init__(self, asked, name):
        self.folder = asked.work / name
        if self.folder.exists():
            shutil.rmtree(self.folder)
        (self.folder / "bench").mkdir(parents=True)
        for frame in ("rest", "mid-stroke"):
            (self.folder / "bench" / f"{frame}.png").write_bytes(picture(frame))
        self.server = subprocess.Popen([asked.washout, "live", "bench", "--no-open"], cwd=self.folder, stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, text=True)
        self.address = next(found.group(0) for found in (re.search(r"http://[\w.:]+/\w+/", line) for line in self.server.stdout) if found)
        self.page = Page(self.address)
        self.page.until("document.readyState === 'complete'", "the page")
        self.page.run(PROBE)
        self.page.until("document.getElementById('frame').options.length === 2", "the frames")

    def api(self):
        with urllib.request.urlopen(self.address + "api/marks") as answer:
            return json.loads(answer.read())

    def settled(self, is_it, what):
        for _ in range(100):
            state = self.api()
            if is_it(state):
                return state
            self.page.run("new Promise(function (done) { setTimeout(done, 50); })")
        raise RuntimeError(f"waited in vain: {what}")

    def close(self, faults):
        faults += [f"{self.folder.name}: {fault}" for fault in self.page.faults]
        self.page.close()
        self.server.terminate()
        self.server.wait(20)


def fill(page, element, text):
    """Types into a field, as a person does."""
    page.run(f"(function () {{ var own = document.querySelector({json.dumps(element)}); own.scrollIntoView({{ block: 'nearest' }}); own.focus(); own.select(); }})()")
    page.type(text)
    page.press("Enter")


def press_on(page, element):
    x, y = page.run(f"""(function () {{ var own = document.querySelector({json.dumps(element)}); own.scrollIntoView({{ block: "nearest" }});
        var box = own.getBoundingClientRect(); return [box.left + box.width / 2, box.top + box.height / 2]; }})()""")
    page.click(x, y)


def show(own, frame, by_keys):
    """Goes to a frame; both frames are one step from each other."""
    here = own.page.run("document.getElementById('frame').value")
    index = own.api()["frames"].index(frame)
    if int(here) != index:
        key, button = ("n", "#frame-next") if index else ("b", "#frame-before")
        if by_keys:
            own.page.press("Escape")
        own.page.press(key) if by_keys else press_on(own.page, button)
    own.page.until(f"document.getElementById('frame').value === '{index}'", frame)
    own.page.run("new Promise(function (done) { setTimeout(done, 300); })")


def on_screen(page, x, y):
    """Where a place of the frame is, while the whole frame is shown."""
    left, top, wide, tall = page.run("""(function () { var box = document.getElementById('picture').getBoundingClientRect();
        return [box.left, box.top, box.width, box.height]; })()""")
    scale = min(wide / WIDE, tall / TALL)
    return left + (wide - scale * WIDE) / 2 + x * scale, top + (tall - scale * TALL) / 2 + y * scale


def move_cross(page, x, y):
    """By arrow keys, 20 screen pixels at a time, then 2, to a place of the frame."""
    def here():
        words = page.run("document.getElementById('cursor').textContent")
        found = re.findall(r"[xy] (-?[\d.]+) px", words)
        return [float(one) for one in found] if found else None
    if here() is None:
        page.press("ArrowRight")
    for modifiers in (SHIFT, 0):
        before = here()
        page.press("ArrowRight", modifiers)
        step = here()[0] - before[0]
        for axis, forth, back in ((0, "ArrowRight", "ArrowLeft"), (1, "ArrowDown", "ArrowUp")):
            off = (x, y)[axis] - here()[axis]
            for _ in range(round(abs(off) / step)):
                page.press(forth if off > 0 else back, modifiers)


def story(asked, faults, by_keys):
    """Every mark is set twice, the twist grows, undone and done again, saved; `measure` says the same."""
    name = "frames-by-keys" if by_keys else "frames-by-pointer"
    own = Frames(asked, name)
    page, some = own.page, stations()[:2] if by_keys else stations()
    fill(page, "#station", " ".join(str(r) for r in some))
    page.run("(function () { var own = document.getElementById('repeats'); own.value = '2'; own.dispatchEvent(new Event('change')); })()")
    for frame in ("rest", "mid-stroke"):
        show(own, frame, by_keys)
        if frame == "rest":
            press_on(page, "#is-rest")
        if by_keys:
            page.run("document.activeElement.blur()")
            page.press("p")
        for r in some:
            for mark in ("leading", "trailing"):
                for k, (x, y) in enumerate(clicks(frame, mark, r)):
                    if not by_keys:
                        page.click(*on_screen(page, x, y))
                    else:
                        move_cross(page, x, y) if k == 0 else page.press("ArrowRight")
                        page.press("Enter")
    fill(page, "[data-key='view.root_angle_deg']", "45")
    state = own.settled(lambda state: state["told"]["report"] and not state["told"]["lacks"], "the twist of all stations")
    readings = state["told"]["report"]["readings"]
    print(f"{name}: " + ", ".join(f"{one['r_mm']} mm {one['twist_deg']:.1f} ± {one['sigma_deg']:.1f} deg" for one in readings))
    page.until(f"document.querySelectorAll('#curve .plot .reading').length === {len(some)}", "the curve")
    count = len(state["marks"]["clicks"])
    page.run("document.activeElement.blur()")
    page.press("u")
    page.press("u")
    own.settled(lambda state: len(state["marks"]["clicks"]) == count - 1, "one click less")
    page.press("r")
    page.press("r")
    own.settled(lambda state: len(state["marks"]["clicks"]) == count, "the click again")
    page.press("s")
    page.until("document.getElementById('save-box').open", "what was saved")
    command = page.run("document.querySelector('#save-body pre').textContent").splitlines()[0].split()
    written = (own.folder / "bench/bench.csv").read_bytes()
    page.press("Escape")
    said = subprocess.run([asked.washout, *command[1:], "--json"], cwd=own.folder, check=True, capture_output=True, text=True)
    if json.loads(said.stdout)["readings"] != readings:
        faults.append(f"{name}: measure says something else than the page")
    if (own.folder / "bench/bench.csv").read_bytes() != written:
        faults.append(f"{name}: measure writes something else than the page")
    if not by_keys:
        guides(own, faults)
        looks(own, asked, faults)
    own.close(faults)


def guides(own, faults):
    """The base line and a scale of known length read millimetres off the picture, and make a station."""
    page = own.page
    page.run("document.getElementById('by-picture').open = true")
    for tool, ends in (("axis", ((100, 100), (100, 400))), ("scale", ((200, 50), (650, 50)))):
        press_on(page, f"#tool-{tool}")
        for x, y in ends:
            page.click(*on_screen(page, x, y))
    fill(page, "#scale-mm", "50")
    x, y = on_screen(page, 460, 240)
    page.ask("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
    words = page.run("document.getElementById('cursor').textContent")
    found = re.search(r"([\d.]+) mm from the base", words)
    if not found or abs(float(found.group(1)) - 40) > 0.3:
        faults.append(f"360 px at 9 px per mm are 40 mm from the base, the page says {words!r}")
    page.run("document.activeElement.blur()")
    page.press("t")
    state = own.settled(lambda state: len(state["marks"]["stations_mm"]) == len(stations()) + 1, "a new station")
    if not any(abs(r - 40) < 0.3 for r in state["marks"]["stations_mm"]):
        faults.append(f"no station at 40 mm: {state['marks']['stations_mm']}")
    page.press("u")
    own.settled(lambda state: len(state["marks"]["stations_mm"]) == len(stations()), "the station taken back")
    words = page.run("document.getElementById('next-point').textContent")
    if "40" in words.split():
        faults.append(f"a station that was taken back is still to be clicked: {words}")
    page.run("document.getElementById('by-picture').open = false; document.getElementById('points').scrollTop = 0")


def looks(own, asked, faults):
    """Wide and narrow, light and dark: nothing overlaps, nothing is cut off, nothing is pale; everything has a name."""
    page = own.page
    for width, height in ((1280, 800), (390, 844), (900, 900), (1920, 1080)):
        for dark in (False, True):
            page.window(width, height, dark)
            page.run("new Promise(function (done) { setTimeout(done, 400); })")
            where = f"frames, {width} px, {'dark' if dark else 'light'}"
            over = page.run("document.documentElement.scrollWidth - document.documentElement.clientWidth")
            if over > 0:
                faults.append(f"{where}: wider than the window by {over} px")
            for what in ("overlaps", "cut", "pale"):
                found = page.run(f"probe.{what}()")
                if found:
                    faults.append(f"{where}: {what}: {found}")
            if asked.pictures:
                page.picture(asked.pictures / f"frames-{width}-{'dark' if dark else 'light'}.png")
            if asked.docs and width == 1280 and not dark:
                page.picture(asked.docs / "frames.png")
    unnamed = page.run("""Array.from(document.querySelectorAll('button, input, select, canvas')).filter(function (own) {
        return own.checkVisibility() && !(own.getAttribute('aria-label') || own.textContent.trim() || (own.labels && own.labels.length)); }).map(function (own) { return own.id || own.outerHTML; })""")
    if unnamed:
        faults.append(f"frames: without a name: {unnamed}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--washout", type=pathlib.Path, default=ROOT / "target/release/washout")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for the screenshots")
    parser.add_argument("--docs", type=pathlib.Path, help="folder for the picture of docs/from-video-to-twist.md")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "target/live")
    asked = parser.parse_args()
    asked.washout, asked.work, faults = asked.washout.resolve(), asked.work.resolve(), []
    for by_keys in (False, True):
        story(asked, faults, by_keys)
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
