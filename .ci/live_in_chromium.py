"""Works the page of `washout live` in headless Chromium, by pointer and by keyboard alone, and says what is wrong with it."""

import argparse
import json
import pathlib
import random
import re
import shutil
import statistics
import subprocess
import sys
import urllib.request

from chromium import CTRL, SHIFT, Page

HERE = pathlib.Path(__file__).parent
PROBE = (HERE / "live_probe.js").read_text()
ROOT = HERE.parent.resolve()
LEAST_FRAMES = 30
# What is done at random, and how often; the probe knows how.
ACTIONS = {"slide": 6, "type": 3, "back": 2, "add": 2, "out": 2, "strength": 3, "case": 3, "undo": 4, "redo": 3, "reset": 0.5, "ask": 0.5,
           "hover": 1, "hypothesis": 0.5, "search": 1, "view": 1, "list": 2, "play": 1, "table": 0.5, "help": 0.3, "reload": 0.1}


class Live:
    """A study with a hidden effect, served and opened."""

    def __init__(self, asked, name, design=None, **window):
        self.folder, self.server = asked.work / name, None
        address = asked.address
        if not address:
            if self.folder.exists():
                shutil.rmtree(self.folder)
            self.folder.mkdir(parents=True)
            for own in ("designs", "measurements"):
                shutil.copytree(ROOT / own, self.folder / own)
            self.study = design
            if not design:
                synthesized(asked, self.folder)
                self.study = next((self.folder / "try").glob("*.toml")).relative_to(self.folder)
            self.server = subprocess.Popen([asked.washout, "live", self.study, "--no-open", *asked.options], cwd=self.folder,
                                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            for line in self.server.stdout:
                found = re.search(r"http://[\w.:]+/\w+/", line)
                if found:
                    address = found.group(0)
                    break
            if not address:
                raise RuntimeError("washout live ended without an address")
        self.address = address
        self.page = Page(address, **window)
        self.page.until("document.readyState === 'complete'", "the page")
        self.page.run(PROBE)
        self.page.until("probe.isReady()", "the first shape")

    def api(self, path):
        with urllib.request.urlopen(self.address + "api/" + path) as answer:
            return json.loads(answer.read() or b"null")

    def rest(self):
        """Waits until the shape is that of the sliders."""
        # A wing that has no shape is searched for a while.
        self.page.until("probe.isResting()", "a shape", 300)
        for _ in range(1000):
            state, shape = self.api("state"), self.api("shape")
            if shape["revision"] >= state["revision"] and (shape["solved"] or shape["settled"]):
                return state, shape
            self.page.run("new Promise(function (done) { setTimeout(done, 50); })")
        raise RuntimeError("the shape does not follow the state")

    def close(self, faults):
        faults += [f"{self.folder.name}: {fault}" for fault in self.page.faults]
        self.page.close()
        if self.server:
            if self.server.poll() is not None:
                faults.append(f"{self.folder.name}: the program ended by itself")
            self.server.terminate()
            self.server.wait(20)


def synthesized(asked, folder):
    """Readings with a hidden effect, in `try`."""
    subprocess.run([asked.washout, "synthesize", ROOT / asked.study, *asked.hidden, "--seed", "11", "--output", "try", "--quiet"],
                   cwd=folder, check=True)


def check(condition, fault, faults):
    if not condition:
        faults.append(fault)
    return condition


def ladder(live):
    return [(row[0], float(row[2])) for row in live.page.run("probe.ladder()") if row[2] != "…"]


def falls_to_noise(live, faults, name):
    """The last step of the ladder is at the noise."""
    live.page.until("probe.ladder().length > 1 && probe.ladder().every(function (row) { return row[2] !== '\u2026'; })", "a ladder")
    steps, noise = ladder(live), live.api("state")["noise_deg"]
    print(f"{name}: " + ", ".join(f"{label} {rms} deg" for label, rms in steps) + f", noise {noise:.3g} deg")
    check(steps[0][1] > 2 * noise, f"{name}: there is no misfit to begin with: {steps}, noise {noise}", faults)
    check(steps[-1][1] < 1.3 * noise, f"{name}: the last step is not at the noise: {steps}, noise {noise}", faults)
    return steps


def story(asked, faults, by_keys):
    """See the misfit, ask, add, undo, redo, save."""
    name = "by-keys" if by_keys else "by-pointer"
    live = Live(asked, name)
    page = live.page

    def do(element, key, modifiers=0):
        if by_keys:
            page.press(key, modifiers)
        else:
            at = page.run(f"""(function () {{ var own = document.querySelector({json.dumps(element)}); own.scrollIntoView({{ block: "nearest" }});
                var box = own.getBoundingClientRect(); return [box.left + box.width / 2, box.top + box.height / 2]; }})()""")
            page.click(*at)

    first = len(page.until("probe.ladder().length && probe.ladder()", "a ladder"))
    check(float(live.api("shape")["chi2"] or 0) > 0, f"{name}: no chi-square", faults)
    do("#ask", "m")
    page.until("!document.getElementById('asked').hidden", "the diagnosis to begin")
    page.until("document.querySelectorAll('.hypotheses li').length > 0", "an answer", 400)
    sentence = page.run("probe.text('#answer .sentence')")
    print(f"{name}: {sentence}")
    check(asked.effect in sentence, f"{name}: {asked.effect} is not found: {sentence}", faults)
    if by_keys:
        tab_to(page, ".hypotheses li button", faults)
        page.until("document.querySelector('#curve .plot .curve.tried') !== null", "the curve of the hypothesis in focus")
        page.press("Enter")
    else:
        hover(page, ".hypotheses li")
        page.until("document.querySelector('#curve .plot .curve.tried') !== null", "the curve of the hypothesis under the pointer")
        if asked.docs:
            page.window(1160, 720)
            page.run("new Promise(function (done) { setTimeout(done, 500); })")
            hover(page, ".hypotheses li")
            page.run("new Promise(function (done) { setTimeout(done, 3000); })")
            page.picture(asked.docs / "live.png")
            page.window(1280, 800)
        do(".hypotheses li button", "a")
    page.until(f"probe.ladder().length > {first}", "the ladder to grow", 120)
    live.rest()
    steps = falls_to_noise(live, faults, name)
    do("#undo", "u")
    page.until(f"probe.ladder().length === {first}", "undo")
    do("#redo", "r")
    page.until(f"probe.ladder().length === {len(steps)}", "redo")
    live.rest()
    check(ladder(live) == steps, f"{name}: after undo and redo the ladder is {ladder(live)}, was {steps}", faults)
    do("#save", "s")
    page.until("document.getElementById('save-box').open", "the box to save")
    do("#save-now", "Enter")
    page.until("document.querySelectorAll('.files li').length", "files", 120)
    files = page.run("Array.from(document.querySelectorAll('.files li')).map(function (own) { return own.textContent; })")
    commands = page.run("(probe.text('#save-body pre') || '').split('\\n').filter(Boolean)")
    print(f"{name}: wrote {', '.join(files)}")
    if live.server:
        same_files(asked, live, files, commands, faults, name)
    live.close(faults)


def same_files(asked, live, files, commands, faults, name):
    """The files of the page are those of the commands that it gives."""
    again = live.folder.with_name(live.folder.name + "-commands")
    if again.exists():
        shutil.rmtree(again)
    again.mkdir()
    for own in ("designs", "measurements"):
        shutil.copytree(ROOT / own, again / own)
    synthesized(asked, again)
    check(commands, f"{name}: no commands", faults)
    for command in commands:
        done = subprocess.run(re.sub(r"^washout\b", str(asked.washout), command), shell=True, cwd=again, capture_output=True, text=True)
        check(done.returncode == 0, f"{name}: {command}: {done.stderr}", faults)
    count = 0
    for file in files:
        for mine in sorted((live.folder / file).rglob("*")) if (live.folder / file).is_dir() else [live.folder / file]:
            other = again / mine.relative_to(live.folder)
            if check(mine.exists() and other.exists(), f"{name}: {mine} is missing ({mine.exists()}, {other.exists()})", faults) and mine.is_file():
                count += 1
                check(mine.read_bytes() == other.read_bytes(), f"{name}: {mine} differs from that of the commands", faults)
    print(f"{name}: {count} files as those of {len(commands)} commands")


def hover(page, element):
    at = page.run(f"""(function () {{ var own = document.querySelector({json.dumps(element)}); own.scrollIntoView({{ block: "nearest" }});
        var box = own.getBoundingClientRect(); return [box.left + box.width / 3, box.top + box.height / 2]; }})()""")
    page.ask("Input.dispatchMouseEvent", type="mouseMoved", x=at[0], y=at[1])


def tab_to(page, element, faults, most=400):
    """Tab until an element has the focus; every stop on the way must be seen and have a visible focus."""
    for _ in range(most):
        page.press("Tab")
        seen = page.run("""(function () { var own = document.activeElement; if (!own || own === document.body) return null;
            var style = getComputedStyle(own), box = own.getBoundingClientRect();
            return [own.matches(%s), style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0, own.tagName + "#" + own.id + "." + own.className,
                    box.width > 0 && box.bottom > 0 && box.top < window.innerHeight]; })()""" % json.dumps(element))
        if seen is None:
            continue
        check(seen[1], f"no visible focus on {seen[2]}", faults)
        check(seen[3], f"the focus is out of sight on {seen[2]}", faults)
        if seen[0]:
            return
    faults.append(f"Tab does not reach {element}")


def keys_on_sliders(live, faults):
    """Arrows move, Backspace goes back, a typed number counts, a wrong one is refused at its place."""
    page = live.page
    page.press("i")
    before, key = page.run("(function () { var own = document.activeElement; return [Number(own.value), own.getAttribute('aria-label')]; })()")
    page.press("ArrowRight")
    page.press("ArrowRight")
    live.rest()
    after = page.run("Number(document.activeElement.value)")
    check(after > before, f"arrows do not move {key}", faults)
    state = live.api("state")
    check(state["undo"], "a move by keys cannot be undone", faults)
    page.until("probe.text('#heard').indexOf('tip twist') >= 0", "a screen reader to be told the tip twist", 10)
    page.press("Backspace")
    live.rest()
    check(page.run("Number(document.activeElement.value)") == before, f"Backspace does not bring {key} back", faults)
    page.press("Tab", SHIFT)
    page.press("Tab", SHIFT)
    field = page.run("document.activeElement.className")
    if "field" not in field:
        page.press("Tab")
    page.run("document.querySelector('#inputs-groups details[open] .field').select()")
    page.run("document.querySelector('#inputs-groups details[open] .field').focus()")
    page.type("many")
    page.press("Enter")
    page.until("Array.from(document.querySelectorAll('.refusal')).some(function (own) { return own.checkVisibility(); })", "a refusal at its place")
    page.run("document.querySelector('#inputs-groups details[open] .field').select()")
    page.type("1e9")
    page.press("Enter")
    page.until("Array.from(document.querySelectorAll('.refusal')).some(function (own) { return own.checkVisibility() && own.textContent.length > 20; })",
               "a refusal by the program")
    page.press("z", CTRL)
    page.run("document.activeElement.blur()")
    page.press("Escape")


def drags(live, faults):
    """A drag of the mouse is one step of undo; a double click goes back."""
    page = live.page
    was = page.run("document.getElementById('undo').disabled")
    box = page.run("(function () { var box = probe.ranges()[0].getBoundingClientRect(); return [box.left, box.top, box.width, box.height]; })()")
    start = page.run("(function () { var own = probe.ranges()[0]; return (own.value - own.min) / (own.max - own.min); })()")
    at = [box[0] + 8 + (box[2] - 16) * start, box[1] + box[3] / 2]
    before = page.run("Number(probe.ranges()[0].value)")
    page.drag(at, [at[0] + 40, at[1]])
    live.rest()
    moved = page.run("Number(probe.ranges()[0].value)")
    check(moved > before, f"the mouse does not drag: {before}, {moved}", faults)
    page.run("new Promise(function (done) { setTimeout(done, 600); })")
    page.run("document.getElementById('undo').click()")
    live.rest()
    check(page.until("Number(probe.ranges()[0].value)", "a value") == before, "a drag is more than one step of undo", faults)
    page.run("document.getElementById('redo').click()")
    live.rest()
    page.run("probe.ranges()[0].dispatchEvent(new MouseEvent('dblclick', { bubbles: true }))")
    live.rest()
    check(page.run("Number(probe.ranges()[0].value)") == before, "a double click does not go back", faults)
    check(was or not page.run("document.getElementById('undo').disabled"), "undo is lost", faults)


def names(page, faults):
    """A screen reader has a name for everything that can be used, and reads numbers."""
    nodes = page.ask("Accessibility.getFullAXTree")["nodes"]
    for node in nodes:
        role, name = node.get("role", {}).get("value"), node.get("name", {}).get("value", "")
        if node.get("ignored") or role not in ("button", "slider", "textbox", "searchbox", "combobox", "tab", "checkbox", "progressbar", "img"):
            continue
        check(name.strip(), f"a {role} without a name: {node.get('properties')}", faults)
        if role == "slider":
            told = [own for own in node.get("properties", []) if own["name"] == "valuetext"]
            check(told, f"the slider {name} does not say its value", faults)


def looks(live, asked, faults):
    """Wide and narrow, light and dark: nothing overlaps, nothing is cut off, nothing is pale; and pictures of it."""
    page = live.page
    for width, height in ((1280, 800), (390, 844), (900, 900), (1100, 700), (1920, 1080)):
        for dark in (False, True):
            page.window(width, height, dark)
            page.run("new Promise(function (done) { setTimeout(done, 500); })")
            where = f"{width} px, {'dark' if dark else 'light'}"
            over = page.run("document.documentElement.scrollWidth - document.documentElement.clientWidth")
            check(over <= 0, f"{where}: wider than the window by {over} px", faults)
            # Of a page that is longer than the window every part is looked at.
            tall = page.run("document.documentElement.scrollHeight") if width < 1080 else height
            for top in range(0, tall, height - 250):
                page.run(f"window.scrollTo(0, {top})")
                for what in ("overlaps", "cut", "pale"):
                    found = page.run(f"probe.{what}()")
                    check(not found, f"{where}, at {top}: {what}: {found}", faults)
            page.run("window.scrollTo(0, 0)")
            if asked.pictures:
                page.picture(asked.pictures / f"live-{width}-{'dark' if dark else 'light'}.png")
    page.window(1280, 800)


def speed(live, asked, faults):
    """Frames while the wing is turned and while a slider is moved; from a move to the new curve."""
    page = live.page
    page.window(1280, 800)
    live.rest()
    turned = page.run("probe.frames(4, probe.turn)")
    moved = page.run("""probe.frames(4, function (count) { var own = probe.ranges()[1], low = Number(own.min), high = Number(own.max);
        probe.slide(own, low + (high - low) * (0.35 + 0.05 * Math.sin(count / 15)), false); })""")
    live.rest()
    for what, own in (("turning", turned), ("moving a slider", moved)):
        print(f"{what}: {own['frames']:.0f} frames a second, longest {own['worst_ms']:.0f} ms")
        check(own["frames"] > LEAST_FRAMES, f"{what}: {own['frames']:.0f} frames a second", faults)
    times, still, chance = [], 0, random.Random(5)
    for _ in range(asked.moves):
        which, share = chance.randrange(3), 0.3 + 0.2 * chance.random()
        took = page.run(f"""(function () {{ var own = probe.ranges()[{which}], low = Number(own.min), high = Number(own.max);
            return probe.moved(own, low + (high - low) * {share}); }})()""")
        if took is None:
            still += 1
        else:
            times.append(took)
    if times:
        print(f"from a move to the new curve: median {statistics.median(times):.0f} ms of {len(times)} moves, longest {max(times):.0f} ms")
    check(still <= asked.moves // 2, f"{still} of {asked.moves} moves did not change the curve", faults)


def sorted_as_shown(page, state):
    """The inputs group by group, as they stand on the page."""
    groups = page.run("Array.from(document.querySelectorAll('#inputs-groups .count')).map(function (own) { return own.getAttribute('data-group'); })")
    return [own for group in groups for own in state["inputs"] if own["group"] == group]


def differences(live):
    """Where the page shows something else than the program says."""
    page, found = live.page, []
    state, shape = live.rest()
    tip = next((own["value"] for own in shape["numbers"] if own["key"] == "tip_twist_deg"), None)
    shown = page.run("probe.text('#figures .main .value')")
    if tip is None or shown is None:
        check(tip is None and shown is None, f"the page shows {shown} deg, the program says {tip}: {shape['refusal']}", found)
    else:
        shown = float(shown.replace("\u2212", "-"))
        check(abs(shown - tip) <= 0.006 * abs(tip) + 1e-6, f"the page shows {shown} deg, the program says {tip}", found)
    # What was refused stays in its field, beside the reason.
    sliders = page.run("""probe.ranges().map(function (own) { var field = own.closest(".mover").querySelector(".field");
        return field.getAttribute("aria-invalid") === "true" ? null : Number(field.value.replace("\u2212", "-")); })""")
    wrong = [own["key"] for own, one in zip(sorted_as_shown(page, state), sliders)
             if one is not None and abs(own["value"] - one) > 1e-4 * abs(own["value"])]
    check(len(sliders) == len(state["inputs"]) and not wrong, f"the sliders do not show {wrong}: {sliders}, {state['inputs']}", found)
    grey = page.run("document.getElementById('grey').hidden")
    check(grey == shape["solved"], f"grey is hidden: {grey}, solved: {shape['solved']}", found)
    return found


def wander(asked, faults):
    """Random sequences of actions: no error on the console, and in the end the page shows what the program says."""
    live, chance = Live(asked, "random"), random.Random(asked.seed)
    page = live.page
    for sequence in range(asked.sequences):
        done = []
        for _ in range(asked.actions):
            action = chance.choices(list(ACTIONS), list(ACTIONS.values()))[0]
            done.append(action)
            if action == "reload":
                page.ask("Page.reload")
                page.until("document.readyState === 'complete' && document.querySelectorAll('.mover').length > 1", "the page again")
                page.run(PROBE)
                page.until("probe.isReady()", "a shape again")
            else:
                page.run(f"probe.act({json.dumps(action)}, {chance.random()}, {chance.random()})")
            if chance.random() < 0.3:
                page.run(f"new Promise(function (done) {{ setTimeout(done, {chance.randrange(150)}); }})")
        page.run("document.getElementById('stop').checkVisibility() && document.getElementById('stop').click()")
        where = f"sequence {sequence} ({' '.join(done)})"
        # A gesture ends a while after its last move, an effect is fitted for some seconds.
        for _ in range(60):
            page.run("new Promise(function (done) { setTimeout(done, 500); })")
            wrong = differences(live)
            if not wrong:
                break
        faults += [f"{where}: {fault}" for fault in wrong]
        if page.faults or len(faults) > 20:
            faults.append(f"{where}: {page.faults}")
            break
    print(f"{asked.sequences} random sequences of {asked.actions} actions")
    live.close(faults)


DROP = """(function () { var held = new DataTransfer(); held.items.add(new File([%s], %s));
    ["dragenter", "dragover", "drop"].forEach(function (kind) {
        window.dispatchEvent(new DragEvent(kind, { dataTransfer: held, bubbles: true, cancelable: true })); }); })()"""
SHEET = "r (mm),twist (deg),sd\n10,2.0,0.5\n20,4.5,0.5\n35,7.5,0.5\n51,16,0.5\n67,22,0.6\n"


def files_in(asked, faults):
    """A table that is dropped is understood and confirmed; what is no design is refused; another design is opened."""
    live = Live(asked, "files", "designs/twist-v2.toml")
    page = live.page
    page.run(DROP % (json.dumps(SHEET), json.dumps("sheet.csv")))
    page.until("document.getElementById('sheet-box').open", "what was understood")
    check("twist" in page.run("probe.text('#sheet-body pre')"), "the table is not understood", faults)
    page.press("Enter")
    page.until("document.querySelectorAll('#curve .plot .reading').length === 5", "the readings of the table")
    page.run(DROP % (json.dumps("nonsense = ["), json.dumps("x.toml")))
    page.until("!document.getElementById('notice').hidden", "a refusal of what is no design")
    page.run("document.getElementById('notice-close').click()")
    page.run(DROP % (json.dumps((live.folder / "designs/rigid.toml").read_text()), json.dumps("rigid.toml")))
    page.until("probe.text('#name') === 'rigid'", "another design")
    live.rest()
    live.close(faults)


def alone(asked, faults):
    """The file for others: at a point of its grid the numbers that were solved, between them what lies between, and it says so."""
    file = asked.work / "alone.html"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    subprocess.run([asked.washout, "live", "designs/twist-v2.toml", "--set", "mesh.refine=0.5", "--export", file,
                    "--over", "flapping.frequency_hz,root-flexure", "--quiet"], cwd=ROOT, check=True)
    check(file.stat().st_size <= 5_000_000, f"the file for others has {file.stat().st_size} bytes", faults)
    text = file.read_text()
    grid = json.loads(re.search(r'id="grid">(.*?)</script>', text, re.S).group(1))
    page = Page(file.as_uri())
    page.until("document.readyState === 'complete'", "the file")
    page.run(PROBE)
    page.until("document.querySelectorAll('.mover').length > 0", "its sliders")
    many, seen = len(grid["axes"][1]["values"]), []
    for index, value in enumerate(grid["axes"][0]["values"]):
        point = grid["points"][index * many + grid["axes"][1]["values"].index(0)]
        page.run(f"(function () {{ var own = document.querySelector('#inputs-groups .field'); own.value = '{value!r}'; own.dispatchEvent(new Event('change')); }})()")
        page.run("new Promise(function (done) { setTimeout(done, 150); })")
        if not point["solved"]:
            check(not page.run("document.getElementById('grey').hidden"), f"at {value}: not solved, and not grey", faults)
            continue
        shown = float(page.run("probe.text('#figures .main .value')").replace("\u2212", "-"))
        seen.append(shown)
        check(abs(shown - point["numbers"][0]) <= 0.006 * abs(point["numbers"][0]), f"at {value}: {shown}, solved {point['numbers'][0]}", faults)
        check("a solved point" in page.run("probe.text('#status')"), f"at {value}: {page.run('probe.text(`#status`)')}", faults)
    low, high = grid["axes"][0]["values"][:2]
    page.run(f"(function () {{ var own = document.querySelector('#inputs-groups .field'); own.value = '{(low + high) / 2!r}'; own.dispatchEvent(new Event('change')); }})()")
    page.run("new Promise(function (done) { setTimeout(done, 150); })")
    check("interpolated" in page.run("probe.text('#status')"), "between two points it does not say that it is interpolated", faults)
    middle = float(page.run("probe.text('#figures .main .value')").replace("\u2212", "-"))
    check(abs(middle - (seen[0] + seen[1]) / 2) <= 0.01 * abs(middle) + 0.01, f"{middle} is not between {seen[0]} and {seen[1]}", faults)
    page.press("u")
    names(page, faults)
    for width, height in ((1280, 800), (390, 844)):
        for dark in (False, True):
            page.window(width, height, dark)
            page.run("new Promise(function (done) { setTimeout(done, 400); })")
            for what in ("overlaps", "cut", "pale"):
                found = page.run(f"probe.{what}()")
                check(not found, f"the file for others, {width} px: {what}: {found}", faults)
    print(f"the file for others: {file.stat().st_size} bytes, {len(grid['points'])} points")
    faults += [f"the file for others: {fault}" for fault in page.faults]
    page.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--washout", type=pathlib.Path, default=ROOT / "target/release/washout")
    parser.add_argument("--address", help="of a page that is served already")
    parser.add_argument("--study", default="studies/three-rods.toml")
    parser.add_argument("--hidden", nargs="*", default=["--effect", "root-flexure=0.2"])
    parser.add_argument("--effect", default="root-flexure")
    parser.add_argument("--options", nargs="*", default=[], help="of washout live")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder for the screenshots")
    parser.add_argument("--docs", type=pathlib.Path, help="folder for the picture of docs/live.md")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "target/live")
    parser.add_argument("--moves", type=int, default=60)
    parser.add_argument("--sequences", type=int, default=20)
    parser.add_argument("--actions", type=int, default=30)
    parser.add_argument("--seed", type=int, default=17, help="of the random sequences")
    parser.add_argument("--only", nargs="*", default=["pointer", "keys", "looks", "files", "alone", "random"])
    asked = parser.parse_args()
    asked.washout, asked.work, faults = asked.washout.resolve(), asked.work.resolve(), []
    if "pointer" in asked.only:
        story(asked, faults, False)
    if "keys" in asked.only:
        story(asked, faults, True)
    if "looks" in asked.only:
        live = Live(asked, "looks")
        names(live.page, faults)
        drags(live, faults)
        keys_on_sliders(live, faults)
        names(live.page, faults)
        looks(live, asked, faults)
        speed(live, asked, faults)
        live.close(faults)
    if "files" in asked.only:
        files_in(asked, faults)
    if "alone" in asked.only:
        alone(asked, faults)
    if "random" in asked.only:
        wander(asked, faults)
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
