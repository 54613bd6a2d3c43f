#!/usr/bin/env bash
# A new user, by script: from a clean clone in a fresh home directory the README's first command, then every tutorial's, in the
# order of the book. Time and output of each step stay in target/new-user, with a table in new-user.md. Needs git, Rust and
# Python 3; what Rust has downloaded already is used again (CARGO_HOME, RUSTUP_HOME). Asks nothing; twenty minutes on two cores,
# most of them for the build.
#
#   .ci/new_user.sh [PAGE]      writes the table into that page as well
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_HOME="${CARGO_HOME:-$HOME/.cargo}" RUSTUP_HOME="${RUSTUP_HOME:-$HOME/.rustup}" CARGO_TERM_COLOR=never
unset CARGO_TARGET_DIR

here=target/new-user
rm -rf $here
mkdir -p $here/home
git clone --quiet . $here/washout
python3 .ci/new_user.py $here
[ $# = 0 ] || cp $here/new-user.md "$1"
