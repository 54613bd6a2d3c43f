#!/usr/bin/env bash
# The book of docs/: built by mdBook into target/book, every link of it followed. Needs Rust and Python 3; brings mdBook
# (into target/tools, some minutes once) where there is none. Asks nothing.
set -euo pipefail
cd "$(dirname "$0")/.."

mdbook=$(command -v mdbook || true)
if [ -z "$mdbook" ]; then
    mdbook=target/tools/bin/mdbook
    [ -x "$mdbook" ] || cargo install --locked --version '^0.5' --root target/tools mdbook
fi
"$mdbook" --version
rm -rf target/book
"$mdbook" build
python3 .ci/book_links.py target/book
echo "the book: target/book/index.html"
