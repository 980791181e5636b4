"""YAML text as plain values, bounded before it is expanded.

A few lines of YAML can stand for more than a memory holds: aliases of aliases, brackets in brackets. So its
events are counted before any value is made of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from planar_pushing.terms.errors import InvalidFile

#: Most bytes of a file, values that it stands for, brackets in brackets, and characters of a value.
BYTES, VALUES, DEPTH, CHARACTERS = 2**20, 10**5, 20, 1000
#: Most characters of a value in a message.
LINE = 120


def shown(given: object) -> str:
    """A value in a message: at most a line of it."""
    text = repr(given)
    return text if len(text) <= LINE else f"{text[: LINE - 3]}..."


def read_yaml(path: Path) -> Any:
    """Content of a YAML file.

    Raises
    ------
    InvalidFile
        Where the file cannot be read, is not YAML, or stands for more than the bounds allow.
    """
    text = _text(path)
    try:
        for problem in _excesses(text):
            raise InvalidFile(f"{path}: {problem}; write it out plainly")
        return YAML(typ="safe", pure=True).load(text)
    except YAMLError as error:
        raise InvalidFile(f"{path}: not YAML: {_where(error)}; mend the line") from None
    except (ValueError, TypeError, LookupError, ArithmeticError, AttributeError) as error:
        # What the parser makes of a date, an escape or a key that there cannot be.
        reason = str(error).partition("\n")[0][:LINE]
        raise InvalidFile(f"{path}: not YAML: {reason}; mend the value") from None


def _text(path: Path) -> str:
    try:
        with path.open("rb") as stream:
            content = stream.read(BYTES + 1)
        if len(content) > BYTES:
            allowed = f"files of at most {BYTES} bytes"
            raise InvalidFile(f"{path}: is larger; allowed: {allowed}; name another file")
        return content.decode("utf-8")
    except FileNotFoundError:
        raise InvalidFile(f"{path}: no such file; give the path of a YAML file") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise InvalidFile(f"{path}: cannot be read ({reason}); give a YAML text file") from None


def _excesses(text: str) -> Iterator[str]:
    """What of the text is more than the bounds allow, from its events."""
    sizes: dict[str, int] = {}
    open_ones: list[list[Any]] = [[None, 0]]
    for event in YAML(typ="safe", pure=True).parse(text):
        kind = type(event).__name__.removesuffix("Event")
        if getattr(event, "tag", None):
            yield f"the tag {shown(str(event.tag))} given; allowed: values without tags"
        if kind in ("MappingStart", "SequenceStart"):
            open_ones.append([event.anchor, 1])
            if len(open_ones) > DEPTH:
                yield f"nested too deep; allowed: {DEPTH} brackets in each other"
            continue
        if kind in ("MappingEnd", "SequenceEnd"):
            anchor, size = open_ones.pop()
        elif kind == "Alias":
            anchor, size = None, sizes.get(event.anchor, VALUES + 1)
        elif kind == "Scalar":
            anchor, size = event.anchor, 1
            if len(event.value) > CHARACTERS:
                yield f"{shown(event.value)} given; allowed: values of {CHARACTERS} characters"
        else:
            continue
        sizes |= {anchor: size} if anchor else {}
        open_ones[-1][1] += size
        if open_ones[-1][1] > VALUES:
            yield f"too many values; allowed: {VALUES}, with those that aliases repeat"


def _where(error: YAMLError) -> str:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or str(error).partition("\n")[0]
    return f"line {mark.line + 1}, column {mark.column + 1}: {problem}" if mark else problem
