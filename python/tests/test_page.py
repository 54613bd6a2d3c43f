"""The page of documentation shows what the package gives, and the notebook runs as it is shown."""

from __future__ import annotations

import copy
import doctest
import re

import nbclient
import nbformat
import pytest
from conftest import REPOSITORY

PAGES = ["docs/python.md", "python/README.md"]
NOTEBOOK = "python/examples/twist.ipynb"


@pytest.mark.parametrize("page", PAGES)
def test_the_page_shows_what_is_printed(page: str) -> None:
    text = (REPOSITORY / page).read_text()
    blocks = re.findall(r"^```pycon\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    shown = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, page, page, 0)
    assert len(shown.examples) > 3
    said: list[str] = []
    failed, _ = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(shown, out=said.append)
    assert failed == 0, "".join(said)


def said(notebook: nbformat.NotebookNode) -> list[str]:
    """The text that the cells of a notebook print, pictures as their names."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    return [output.get("text") or output["data"]["text/plain"] for output in outputs]


def test_the_notebook_prints_what_it_shows() -> None:
    path = REPOSITORY / NOTEBOOK
    shown = nbformat.reads(path.read_text(), as_version=4)  # type: ignore[no-untyped-call]
    fresh = copy.deepcopy(shown)
    nbclient.NotebookClient(fresh, timeout=300, coalesce_streams=True, resources={"metadata": {"path": path.parent}}).execute()
    assert said(fresh) == said(shown) and len(said(shown)) > 8
    pictures = [output for cell in fresh.cells for output in cell.get("outputs", []) if "image/png" in output.get("data", {})]
    assert len(pictures) >= 3
