"""What a notebook shows of a result."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape


def table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A table as HTML; floats with four digits."""
    head = "".join(f"<th>{escape(word)}</th>" for word in heads)
    body = "".join(f"<tr>{''.join(f'<td>{escape(shown(value))}</td>' for value in row)}</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def answer(sentence: str, *parts: str) -> str:
    """A sentence and what stands under it."""
    return f"<div><p><b>{escape(sentence)}</b></p>{''.join(parts)}</div>"


def shown(value: object) -> str:
    """A value as text; empty where there is none."""
    match value:
        case None:
            return ""
        case float():
            return f"{value:.4g}"
        case list() | tuple():
            return " / ".join(shown(part) for part in value)
        case _:
            return str(value)
