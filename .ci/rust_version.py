"""Whether the Rust that Cargo.toml asks for is new enough for every dependency.

    cargo metadata --format-version 1 --all-features --locked | python3 .ci/rust_version.py
"""

import json
import sys

packages = json.load(sys.stdin)["packages"]


def parts(version):
    numbers = [int(part) for part in (version or "0").split("-")[0].split(".")]
    return tuple(numbers + [0, 0])[:3]


own = next(package for package in packages if package["source"] is None and package["name"] == "washout")
newer = [
    f"{package['name']} {package['version']} asks for Rust {package['rust_version']}"
    for package in packages
    if parts(package["rust_version"]) > parts(own["rust_version"])
]
print("\n".join(newer) or f"Rust {own['rust_version']} is enough for {len(packages) - 1} dependencies")
if newer:
    sys.exit(f"raise rust-version = \"{own['rust_version']}\" in Cargo.toml")
