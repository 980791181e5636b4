"""YAML files as plain values; only small files without aliases and tags are read."""

from __future__ import annotations

import itertools
import re
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.composer import Composer, ComposerError
from ruamel.yaml.error import YAMLError
from ruamel.yaml.events import AliasEvent
from ruamel.yaml.nodes import ScalarNode

from planar_pushing.terms.errors import InvalidFile

#: Maximum size of a file, in bytes.
BYTES = 2**18
#: Maximum number of characters of a value in a message.
LINE = 120
#: Digits after a decimal comma.
FRACTION = re.compile(r"\d[\d.]*([eE][-+]?\d+)?")
#: Maximum number of characters of an integer: beyond it, no number of 64 bits is that large.
DIGITS = 400
#: First bytes of a netCDF4 file.
NETCDF4 = b"\x89HDF"


class _Plain(Composer):
    """Composer that rejects aliases, which can expand to more than fits in memory."""

    def compose_node(self, parent: Any, index: Any) -> Any:
        if self.parser.check_event(AliasEvent):
            event = self.parser.peek_event()
            raise ComposerError(None, None, "aliases are not allowed", event.start_mark)
        return super().compose_node(parent, index)

    def compose_scalar_node(self, anchor: Any) -> Any:
        node = super().compose_scalar_node(anchor)
        if str(node.tag).endswith(":int") and len(node.value) > DIGITS:
            raise _TooManyDigits(node.value, node.start_mark)
        return node

    def compose_mapping_node(self, anchor: Any) -> Any:
        node = super().compose_mapping_node(anchor)
        for (key, value), (rest, nothing) in itertools.pairwise(node.value):
            if node.flow_style and _is_split(value, rest, nothing):
                raise _DecimalComma(
                    str(key.value)[:LINE], f"{value.value},{rest.value}", value.start_mark
                )
        return node


class _TooManyDigits(Exception):
    """An integer of so many digits that Python may refuse to print it, or to read it."""

    def __init__(self, text: str, mark: Any) -> None:
        super().__init__(
            f"line {mark.line + 1}, column {mark.column + 1}: an integer of {len(text)} characters given; "
            f"allowed: at most {DIGITS}; write a number such as 1.5e3"
        )


class _DecimalComma(Exception):
    """A number with a decimal comma: `{a: 0,5}` is the mapping `{a: 0, 5: null}`."""

    def __init__(self, key: str, text: str, mark: Any) -> None:
        super().__init__(
            f"line {mark.line + 1}, column {mark.column + 1}: {key}: {text!r} given; allowed: a number "
            "with a decimal point, since a comma ends a value; write the point"
        )


def _is_split(value: Any, rest: Any, nothing: Any) -> bool:
    """Whether a value and the next key, which has no value, look like a number with a decimal comma."""
    nodes = value, rest, nothing
    if not all(isinstance(node, ScalarNode) and not node.style for node in nodes):
        return False
    first, last = re.fullmatch(r"[-+]?\d+", value.value), re.fullmatch(FRACTION, rest.value)
    return bool(first and last and not nothing.value)


def format_entry(value: object) -> str:
    """Text of a value in a message, shortened to one line."""
    text = repr(value)
    return text if len(text) <= LINE else f"{text[: LINE - 3]}..."


def read_yaml(path: Path) -> Any:
    """Content of a YAML file.

    Raises
    ------
    InvalidFile
        If the file cannot be read, is too large, is not YAML, has aliases or tags, or has a number with a
        decimal comma or with hundreds of digits.
    """
    text = _text(path)
    loader = YAML(typ="safe", pure=True)
    loader.Composer = _Plain
    try:
        return loader.load(text)
    except (_DecimalComma, _TooManyDigits) as error:
        raise InvalidFile(f"{path}: {error}") from None
    except YAMLError as error:
        raise InvalidFile(f"{path}: not YAML: {_where(error)}; correct the line") from None
    except (ValueError, TypeError, LookupError, ArithmeticError, AttributeError) as error:
        # The parser fails in this way at an invalid date, escape or key.
        reason = re.split("[\n;]", str(error))[0][:LINE]
        raise InvalidFile(f"{path}: not YAML: {reason}; correct the value") from None
    except RecursionError:
        raise InvalidFile(f"{path}: not YAML: nested too deeply; reduce the nesting") from None


def _text(path: Path) -> str:
    try:
        with path.open("rb") as stream:
            content = stream.read(BYTES + 1)
        if content.startswith(NETCDF4):
            description = "a netCDF4 file, such as a log or a dataset"
            raise InvalidFile(
                f"{path}: is {description}; allowed: a YAML file; give a scene or a study"
            )
        if len(content) > BYTES:
            allowed = f"files of at most {BYTES} bytes"
            raise InvalidFile(f"{path}: is too large; allowed: {allowed}; choose another file")
        return content.decode("utf-8")
    except FileNotFoundError:
        raise InvalidFile(f"{path}: no such file; give the path of a YAML file") from None
    except UnicodeDecodeError:
        raise InvalidFile(f"{path}: is not text in UTF-8; give a YAML text file") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise InvalidFile(f"{path}: cannot be read ({reason}); give a YAML text file") from None


def _where(error: YAMLError) -> str:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or str(error).partition("\n")[0]
    problem = problem.removeprefix("but ")  # of a second document, the parser tells half a sentence
    return f"line {mark.line + 1}, column {mark.column + 1}: {problem}" if mark else problem
