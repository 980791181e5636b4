"""Text of the report's tables, and writing it to a file."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Sequence

from planar_pushing.study.replacing import replacing

PathLike = str | os.PathLike[str]
Rows = Sequence[dict[str, str]]


def json_text(content: object) -> str:
    """Content as JSON, one value a line."""
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def csv_text(rows: Rows) -> str:
    """Rows as CSV under the keys of the first."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return stream.getvalue()


def write_text(text: str, path: PathLike) -> None:
    """Write a table whole or not at all."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
