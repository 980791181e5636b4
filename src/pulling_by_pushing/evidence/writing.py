"""Tables as text, and functions that write them to a file."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping, Sequence

from planar_pushing.terms.replacing import PathLike, replacing

Rows = Sequence[Mapping[str, object]]


def json_text(content: object) -> str:
    """Content as JSON, one value per line."""
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def csv_text(rows: Rows, names: Sequence[str] = ()) -> str:
    """Rows as CSV under these names, by default the keys of the first row."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, fieldnames=names or list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return stream.getvalue()


def write_text(text: str, path: PathLike) -> None:
    """Write a table completely or not at all."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
