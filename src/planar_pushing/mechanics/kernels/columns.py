"""Fields of the core's records by name, in rows of an array."""

from __future__ import annotations

from typing import Any

from planar_pushing.core._record import Record
from planar_pushing.terms.numbers import Array


class Columns:
    """The fields of a record in the last axis of an array, to read and to write.

    Parameters
    ----------
    record : type
    numbers : ndarray, shape S + (columns,)

    Examples
    --------
    ``Columns(LogRow, rows).time`` has the shape S, and the components of ``force`` have S + (2,).
    """

    def __init__(self, record: type[Record], numbers: Array) -> None:
        vars(self).update(record=record, numbers=numbers)

    def __getattr__(self, name: str) -> Any:
        """The values of a field."""
        return vars(self)["numbers"][..., vars(self)["record"].places[name]]

    def __setattr__(self, name: str, values: Any) -> None:
        """Store the values of a field."""
        vars(self)["numbers"][..., vars(self)["record"].places[name]] = values


def row_of(record: type[Record], **values: Any) -> list[Any]:
    """The numbers of a record, in its order, from a value, or several components, of each field."""
    assert values.keys() == record.places.keys(), values.keys() ^ record.places.keys()
    if len(record.places) == record.size:
        return [values[name] for name in record.places]
    row: list[Any] = []
    for name in record.places:
        value = values[name]
        if isinstance(value, (list, tuple)):
            row += value
        else:
            row.append(value)
    return row
