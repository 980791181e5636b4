"""Sequential reading of lines of numbers from a text file; errors name file, push and line."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from planar_pushing.mechanics.plane import Array
from planar_pushing.terms.errors import InvalidFile, number_of


class Lines:
    """The nonempty lines of a file, read in order."""

    def __init__(self, file: Path) -> None:
        self.file, self._next, self._push = file, 0, ""
        try:
            text = file.read_text(encoding="ascii")
        except OSError as error:
            raise InvalidFile(
                f"{file}: cannot be read ({error.strerror}); name another file"
            ) from None
        except UnicodeDecodeError:
            raise InvalidFile(f"{file}: is not a text file of numbers; name another file") from None
        every = enumerate(text.splitlines(), 1)
        self._lines = [(number, line) for number, line in every if line.strip()]

    @property
    def left(self) -> int:
        """Number of lines not yet read."""
        return len(self._lines) - self._next

    def of_push(self, number: int, count: int | None = None) -> Lines:
        """The same lines, which messages attribute to a push from now on."""
        self._push = f"push {number}" + ("" if count is None else f" of {count}")
        return self

    def back(self) -> None:
        """Step back, so that the last line is read again."""
        self._next -= 1

    def next_numbers(self, kind: str = "a number") -> list[float]:
        """The numbers on the next line."""
        if not self.left:
            last = self._lines[-1][0] if self._lines else 0
            where = f"in {self._push} " if self._push else ""
            raise InvalidFile(
                f"{self.file}: cut short {where}after line {last}, where {kind} is missing; copy it again"
            )
        self._next += 1
        try:
            row = [float(word) for word in self._lines[self._next - 1][1].split()]
        except ValueError:
            raise self.wrong(f"holds no numbers, where {kind} is expected") from None
        if not np.isfinite(row).all():
            raise self.wrong(f"holds a number that is not finite in {kind}")
        return row

    def count(self, kind: str, minimum: int = 0) -> int:
        """Read a whole number from a separate line."""
        row = self.next_numbers(kind)
        if len(row) != 1:
            count = number_of(len(row), "number")
            raise self.wrong(f"holds {count}, where {kind} is expected: the counts do not match")
        if row[0] != int(row[0]) or row[0] < minimum:
            raise self.wrong(f"holds {row[0]:g}, where {kind} is expected, at least {minimum}")
        return int(row[0])

    def rows(self, count: int, width: int, kind: str) -> Array:
        """Read the next lines as an array of shape (count, width)."""
        return np.array([self._row(width, kind) for _ in range(count)]).reshape(count, width)

    def _row(self, width: int, kind: str) -> list[float]:
        row = self.next_numbers(kind)
        if len(row) == width:
            return row
        if not self.left:
            raise self.wrong(
                f"ends after {len(row)} of the {width} numbers of {kind}: it is cut short"
            )
        raise self.wrong(
            f"holds {number_of(len(row), 'number')}, where {kind} has {width}: the counts do not match"
        )

    def wrong(self, fault: str) -> InvalidFile:
        """The error for the line that was read last."""
        line = self._lines[max(self._next - 1, 0)][0]
        where = f" ({self._push})" if self._push else ""
        return InvalidFile(f"{self.file}: line {line}{where} {fault}; copy the log again")
