"""Does what README and tutorials say in a clean clone, as a new user would: see new_user.sh.

    python3 .ci/new_user.py HERE      HERE/washout is the clone, HERE/home an empty folder
"""

import os
import platform
import re
import subprocess
import sys
import time

here = os.path.abspath(sys.argv[1])
clone = os.path.join(here, "washout")
environment = dict(os.environ, HOME=os.path.join(here, "home"))
environment["PATH"] = os.path.join(clone, "target/release") + ":" + environment["PATH"]


def text_of(page):
    with open(os.path.join(clone, page), encoding="utf-8") as file:
        return file.read()


def tutorials():
    """Pages and titles of the book's first part."""
    part = text_of("docs/SUMMARY.md").split("# Tutorials")[1].split("\n# ")[0]
    return [("docs/" + page, title) for title, page in re.findall(r"\[(.*?)\]\((.*?)\)", part)]


def commands(block):
    """Lines of a block that are commands; a backslash continues one."""
    lines = block.replace("\\\n", " ").splitlines()
    return [line for line in lines if line.startswith("washout ")]


def steps(page):
    """('write', name, text) and ('run', command, exit code), as tests/docs/page.rs reads them."""
    marks = []
    pattern = re.compile(r"^<!-- ([^\n]*) -->$|^```(\w*)\n(.*?)^```$|^\d+\. `((?:washout|cat) [^`]*)`|^(\S[^\n]*)$", re.M | re.S)
    for mark, language, block, numbered, _ in pattern.findall(page):
        marked = {word: rest for word, _, rest in (old.partition(" ") for old in marks)}
        if mark:
            marks.append(mark)
            continue
        if numbered:
            yield "run", numbered, 0
        elif block:
            if "file" in marked:
                yield "write", marked["file"], block
            elif "washout" in marked:
                yield "run", "washout " + marked["washout"], 0
            elif "from" not in marked and language in ("", "console"):
                prompted = [line[2:] for line in block.splitlines() if line.startswith("$ ")]
                found = prompted if language == "console" else commands(block)
                codes = [0] * len(found)
                if "fails" in marked:
                    codes[-1] = int(marked["fails"].split()[-1])
                for command, code in zip(found, codes):
                    yield "run", command, code
        marks = []


rows, count = [], 0


def run(title, command, code):
    global count
    count += 1
    print(f"{count:3} {title}: {command}", flush=True)
    start = time.monotonic()
    done = subprocess.run(
        ["sh", "-c", command], cwd=clone, env=environment, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
    )
    seconds = time.monotonic() - start
    with open(os.path.join(here, "outputs", f"{count:02}.txt"), "w", encoding="utf-8") as file:
        file.write(f"$ {command}\n{done.stdout}")
    rows.append((title, command, seconds))
    if done.returncode != code:
        sys.exit(f"{done.stdout}\nstep {count} ended with exit code {done.returncode}, expected {code}: {command}")


os.makedirs(os.path.join(here, "outputs"))
first = re.search(r"^cargo run .*$", text_of("README.md"), re.M).group()
run("README", first, 0)
for page, title in tutorials():
    for kind, what, more in steps(text_of(page)):
        if kind == "write":
            with open(os.path.join(clone, what), "w", encoding="utf-8") as file:
                file.write(more)
        else:
            run(title, what, more)

total = sum(seconds for _, _, seconds in rows)
table = "".join(
    f"| {title if index == 0 or rows[index - 1][0] != title else ''} | `{command.replace('|', chr(92) + '|')}` | {seconds:.1f} |\n"
    for index, (title, command, seconds) in enumerate(rows)
)
commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=clone, text=True, capture_output=True, check=True).stdout.strip()
with open(os.path.join(here, "new-user.md"), "w", encoding="utf-8") as file:
    file.write(f"""# A new user, by script

`.ci/new_user.sh` wrote this page. It makes a clean clone (at {commit}) and a fresh home directory. There it runs the
README's first command and then every command of the tutorials, in the order of the book. Every one ended as its page
says. There were {len(rows)} steps, {total / 60:.0f} minutes in all. The first step, which builds everything, took {rows[0][2] / 60:.0f}. The machine had {os.cpu_count()} {platform.machine()}
cores, shared with other work. The outputs stay in `target/new-user/outputs`.

| page | command | seconds |
|---|---|---|
{table}""")
print(f"{len(rows)} steps, {total:.0f} s; {os.path.join(here, 'new-user.md')}")
