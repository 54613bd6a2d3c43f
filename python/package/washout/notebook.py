"""What a notebook shows of a result."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any

from numpy.typing import NDArray


def table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A table as HTML; floats with four digits."""
    head = "".join(f"<th>{escape(word)}</th>" for word in heads)
    body = "".join(f"<tr>{''.join(f'<td>{escape(shown(value))}</td>' for value in row)}</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def answer(sentence: str, *parts: str) -> str:
    """A sentence and what stands under it."""
    return f"<div><p><b>{escape(sentence)}</b></p>{''.join(parts)}</div>"


def of_profile(title: str, profile: Mapping[str, NDArray[Any]]) -> str:
    """Twist along the span under the `repr` of a result."""
    rows = zip(profile["r_mm"].tolist(), profile["twist_deg"].tolist(), strict=True)
    return answer(title.strip("<>"), table(("r, mm", "twist, deg"), rows))


def tip(twist_deg: float | None) -> str:
    """The twist of the tip in words."""
    return "no tip" if twist_deg is None else f"tip twist {twist_deg:.2f} deg"


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
