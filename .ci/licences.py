#!/usr/bin/env python3
"""Every dependency comes from crates.io under a licence that deny.toml allows. Stands in for `cargo deny check licenses sources`
where that is not installed: reads `cargo metadata` from standard input. Arguments: licences
allowed besides."""
import json
import pathlib
import re
import sys
import tomllib

allowed = {*tomllib.loads(pathlib.Path("deny.toml").read_text())["licenses"]["allow"], *sys.argv[1:]}


def permits(expression):
    """Whether an SPDX expression (OR, AND, WITH, parentheses) can be met; a licence WITH an exception is one of its own."""
    words = re.findall(r"\(|\)|[^\s()]+(?: WITH [^\s()]+)?", expression.replace("/", " OR "))
    python = []
    for word in words:
        if word in "()":
            python.append(word)
        elif word in ("OR", "AND"):
            python.append(word.lower())
        else:
            python.append(str(word in allowed))
    return eval(" ".join(python))  # words are True, False, and, or and parentheses only


faults = []
for package in json.load(sys.stdin)["packages"]:
    name = f"{package['name']} {package['version']}"
    source = package["source"]
    if source is not None and not source.startswith("registry+https://github.com/rust-lang/crates.io-index"):
        faults.append(f"{name}: comes from {source}")
    if not package["license"] or not permits(package["license"]):
        faults.append(f"{name}: licence {package['license']}")
print("\n".join(faults) or "all dependencies are from crates.io under licences that deny.toml allows")
sys.exit(bool(faults))
