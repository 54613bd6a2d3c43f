#!/usr/bin/env bash
# Opens `washout live` in Debian's Chromium without a screen, on a study with a hidden effect: the misfit is seen, what is missing is
# asked and added, the error falls to the noise, undone, redone, saved as the commands would; the same by keyboard alone; random
# sequences of actions; wide and narrow, light and dark; frames a second. Then frames of a video are marked, by pointer and by keyboard.
# Installs chromium where it is not.
# Usage: .ci/live_in_chromium.sh [OPTION of live_in_chromium.py ...]
set -euo pipefail
cd "$(dirname "$0")/.."
export DEBIAN_FRONTEND=noninteractive

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }

if ! command -v chromium >/dev/null; then
    as_root apt-get update -q
    as_root apt-get install -qy --no-install-recommends chromium fonts-dejavu-core
fi

cargo build --release --quiet
mkdir -p target/live/pictures
python3 .ci/live_in_chromium.py --pictures target/live/pictures --docs docs/pictures "$@"
python3 .ci/frames_in_chromium.py --pictures target/live/pictures --docs docs/pictures
