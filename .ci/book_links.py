"""Completes and checks a built book: BOOK/docs holds the pages, as mdBook made them from docs/.

What pages link to outside of docs/ (designs, examples, README, ...) is copied beside them, so that the book stands by itself, and
BOOK/index.html leads to its first page. Then every relative link and picture of every page must lead to a file, and every
`#name` to an element of that name.

    python3 .ci/book_links.py target/book
"""

import os
import re
import shutil
import sys
import urllib.parse

root = os.getcwd()
book = os.path.abspath(sys.argv[1])
pages = os.path.join(book, "docs")
tag_link = re.compile(r'(?:href|src)="([^"]+)"')
identifier = re.compile(r'\b(?:id|name)="([^"]+)"')


def html_files():
    for folder, _, names in os.walk(pages):
        for name in names:
            if name.endswith(".html") and name not in ("toc.html", "404.html"):
                yield os.path.join(folder, name)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def own_links(path, text):
    """Links without a scheme: as written, the file that they name, the place in it."""
    for link in tag_link.findall(text):
        if re.match(r"[a-z]+:|//", link):
            continue
        file, _, place = urllib.parse.unquote(link).partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
        yield link, target, place


# pages of the repository that are none of the book keep their ending
for path in html_files():
    text = text_of(path)
    for link, target, _ in own_links(path, text):
        source = os.path.join(root, os.path.relpath(target, book))
        if not target.startswith(pages + os.sep) and target.endswith(".html") and os.path.exists(source[:-5] + ".md"):
            text = text.replace(f'"{link}"', '"' + link.replace(".html", ".md", 1) + '"')
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)

copied = 0
for path in list(html_files()):
    for link, target, _ in own_links(path, text_of(path)):
        source = os.path.join(root, os.path.relpath(target, book))
        if target.startswith(book + os.sep) and not os.path.exists(target) and os.path.exists(source):
            os.makedirs(os.path.dirname(target), exist_ok=True)
            if os.path.isdir(source):
                shutil.copytree(source, target)
            else:
                shutil.copy(source, target)
            copied += 1

with open(os.path.join(book, "index.html"), "w", encoding="utf-8") as file:
    file.write('<!doctype html><meta http-equiv="refresh" content="0; url=docs/book.html"><a href="docs/book.html">washout</a>\n')

followed, broken, names = 0, [], {}
for path in html_files():
    for link, target, place in own_links(path, text_of(path)):
        followed += 1
        shown = f"{os.path.relpath(path, book)}: {link}"
        if not target.startswith(book + os.sep):
            broken.append(shown + " leads out of the book")
        elif not os.path.exists(target):
            broken.append(shown + " leads nowhere")
        elif place and target.endswith(".html"):
            if target not in names:
                names[target] = set(identifier.findall(text_of(target)))
            if place not in names[target]:
                broken.append(shown + " has no such place")
print(f"{followed} links followed, {copied} files of the repository beside the pages")
print("\n".join(sorted(set(broken))))
if broken or followed < 500:
    sys.exit(f"{len(set(broken))} broken links of {followed}")
