"""Arguments and printed text that the commands share."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from planar_pushing.terms.errors import (
    InvalidFile,
    InvalidValue,
    PlanarPushingError,
    require_number,
    require_positive,
    suggestion,
)

if TYPE_CHECKING:
    import xarray as xr

#: Return type of `add_subparsers`, for which argparse has no public name.
Commands = Any
#: Function that runs a command with its arguments and returns the values to print.
Action = Callable[[argparse.Namespace], dict[str, Any]]

#: Option of the direction of a push.
PUSHER_ANGLE = "--pusher-angle"
DIRECTION = (
    "degrees counterclockwise from the fence, any finite number; 90 is straight into the slider"
)


#: Help for the file of an outline.
OUTLINE = (
    "YAML file of the object's corners, [[x, y], ...], or of its shape, as in {disc: {radius: 40}}, or "
    "a scene file with object.outline"
)


class Parser(argparse.ArgumentParser):
    """A parser that reports an error in the arguments in one line.

    Attributes
    ----------
    words : tuple of str
        Choices of its first positional argument, and options that it reads itself, for shell completion.
    values : mapping
        Choices by option, or a shell command that prints them, for shell completion.
    open : bool
        Whether the command itself reads the options that the parser does not know.
    number_option : str
        Option that a number without an option may be meant for.
    """

    words: tuple[str, ...] = ()
    values: Mapping[str, tuple[str, ...] | str] = {}
    open: bool = False
    number_option: str = ""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        # Words that begin like a negative number are values, such as the range -90:90:5.
        self._negative_number_matcher = re.compile(r"-\.?\d|-inf$|-nan$", re.IGNORECASE)
        self.register("type", float, _number)
        self.register("type", int, _whole_number)
        self.register("type", Path, _path)

    @property
    def options(self) -> list[str]:
        """The long options, in the order of the help text."""
        # argparse has no public list of the options.
        return [name for name in self._option_string_actions if name.startswith("--")]

    def require_known(self, words: Sequence[str]) -> None:
        """Reject a mistyped option, before one that is missing for this reason is asked for."""
        for word in words if not self.open else ():
            name = word.partition("=")[0]
            if name == "--":
                return
            if name.startswith("--") and name not in self.options:
                remedy = suggestion(name, self.options, "choose one of these")
                self.error(f"{name} given; allowed: {', '.join(self.options)}; {remedy}")

    def require_once(self, words: Sequence[str]) -> None:
        """Reject an option with a value that is given twice, of which argparse would use the last."""
        before = set()
        for word in words:
            if word == "--":
                return
            name = word.partition("=")[0] if word.startswith("--") else word[:2]
            action = self._option_string_actions.get(name)
            if action is not None and action.nargs != 0:
                if action.dest in before:
                    self.error(f"{name} given twice; allowed: once; remove one of them")
                before.add(action.dest)

    def split(self, words: Sequence[str]) -> tuple[list[str], list[str]]:
        """Words that the parser reads, and the other options of an open command with their values."""
        known: list[str] = []
        others: list[str] = []
        rest = list(words)
        while self.open and rest and rest[0] != "--":
            word = rest.pop(0)
            is_other = word.startswith("--") and word.partition("=")[0] not in self.options
            (others if is_other else known).append(word)
            if is_other and "=" not in word and rest and self._is_value(rest[0]):
                others.append(rest.pop(0))
        return [*known, *rest], others

    def _is_value(self, word: str) -> bool:
        return not word.startswith("-") or self._negative_number_matcher.match(word) is not None

    def require_no_more(self, words: Sequence[str]) -> None:
        """Reject words that remain; a number probably lacks its option."""
        is_number = len(words) == 1 and re.match(r"-?\.?\d", words[0])
        remedy = f"type {self.number_option} {words[0]}" if is_number and self.number_option else ""
        if words:
            given = " ".join(words)
            self.error(f"{given!r} given; allowed: nothing more; {remedy or 'remove it'}")

    def error(self, message: str) -> NoReturn:
        without_value = re.fullmatch(r"argument (\S+): expected .*", message)
        if without_value:
            name = without_value[1].rpartition("/")[2]
            action = self._option_string_actions[name]
            values = action.metavar if isinstance(action.metavar, tuple) else (action.metavar,)
            form = " ".join(map(str, values))
            message = f"{name}: value missing; allowed: {name} {form}; add what is missing"
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} given; allowed: a number") from None


def _path(text: str) -> Path:
    if not text:  # of which `Path` would make the current folder
        raise argparse.ArgumentTypeError("'' given; allowed: a path; name a file or a folder")
    return Path(text)


def _whole_number(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} given; allowed: a whole number") from None


#: Maximum number of angles in a range: a minute of work.
MOST_ANGLES = 100_000


def angles(text: str) -> float | tuple[float, ...]:
    """Parse an angle, or the angles of START:STOP:STEP, which include STOP if the steps reach it."""
    try:
        values = tuple(map(float, text.split(":")))
        if len(values) == 1:
            return values[0]
        start, stop, step = values
        count = math.floor((stop - start) / step + 1e-9) + 1
        if not 0 < count <= MOST_ANGLES:
            raise ValueError
    except (ValueError, OverflowError, ZeroDivisionError):
        raise argparse.ArgumentTypeError(
            f"{text!r} given; allowed: a number, or START:STOP:STEP with a step toward STOP and at most "
            f"{MOST_ANGLES} angles"
        ) from None
    return tuple(start + i * step for i in range(count))


def command(commands: Commands, name: str, action: Action, about: str, example: str = "") -> Parser:
    """Add a command with an example; its results are printed as text or as JSON."""
    sub: Parser = commands.add_parser(
        name, help=about, description=about, allow_abbrev=False,
        epilog=f"example: planar-pushing {name} {example}".rstrip(),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    sub.set_defaults(action=action)
    sub.add_argument("--json", action="store_true", help="print JSON instead of text")
    return sub


def add_scene(sub: argparse.ArgumentParser) -> None:
    """Add the path of a scene file."""
    about = "scene file: the slider, the contact law and the effects that resist its motion"
    sub.add_argument("scene", type=Path, metavar="SCENE.yaml", help=about)


def add_output(sub: argparse.ArgumentParser, example: str, about: str) -> None:
    """Add the path of the output file."""
    sub.add_argument("-o", "--output", type=Path, required=True, metavar=example, help=about)


def add_push(sub: Parser, ranges: bool) -> None:
    """Add the pusher's motion, whose angle can be a range."""
    sub.number_option = PUSHER_ANGLE
    metavar = "DEGREES|START:STOP:STEP" if ranges else "DEGREES"
    default = "that of the scene file" if ranges else "that of the scene file, or 90"
    size = "that of the file if its angle is used, or 1" if ranges else "that of the file, or 1"
    sub.add_argument(
        PUSHER_ANGLE, type=angles if ranges else float, metavar=metavar,
        help=f"direction of the fence's motion, {DIRECTION} (default: {default})"
        + ("; a range, which includes STOP, prints a table" if ranges else ""),
    )  # fmt: skip
    sub.add_argument(
        "--pusher-magnitude", type=float, metavar="NUMBER",
        help="magnitude of the fence's velocity, or with inertia of its acceleration from rest; a finite "
        f"number > 0 in the scene's units (default: {size})",
    )  # fmt: skip


def check_push(args: argparse.Namespace) -> None:
    """Reject angles and magnitudes that the fence cannot have."""
    for name in ("pusher_angle", "force_angle"):
        degrees = getattr(args, name, None)
        if degrees is not None and not isinstance(degrees, tuple):
            allowed = "a finite number of degrees"
            require_number(name, degrees, math.isfinite, allowed, "give one angle")
    magnitude = getattr(args, "pusher_magnitude", None)
    if magnitude is not None:
        require_positive("pusher_magnitude", magnitude, "use the angle to reverse the pusher")


def add_pushes(sub: argparse.ArgumentParser, several: bool) -> None:
    """Add the dataset of pushes, the name of an object, and the seed."""
    sub.add_argument(
        "pushes", type=Path, metavar="PUSHES.nc",
        help="dataset of pushes written by save_pushes or planar-pushing convert",
    )  # fmt: skip
    default = "all objects of the dataset" if several else "the only object of the dataset"
    sub.add_argument(
        "--object", metavar="NAME", help=f"object whose pushes are used (default: {default})"
    )
    sub.add_argument(
        "--seed", type=int, default=0, metavar="NUMBER",
        help="seed of all random choices, a whole number >= 0 (default: 0)",
    )  # fmt: skip


def missing_value(name: str, allowed: str, remedy: str) -> PlanarPushingError:
    """The error for what the user must give and has not."""
    return PlanarPushingError(f"{name}: missing; allowed: {allowed}; {remedy}")


def require_seed(seed: int) -> int:
    """Return a valid seed, or raise `InvalidValue`."""
    allowed = "a whole number >= 0"
    return int(require_number("seed", seed, lambda x: 0 <= x < math.inf, allowed, "give another"))


def require_ending(output: Path, endings: Sequence[str]) -> None:
    """Reject an output file name without one of the allowed endings."""
    if output.suffix.lower() not in endings:
        allowed = f"a name ending in {' or '.join(endings)}"
        raise InvalidValue("output", str(output), allowed, "rename the file")


def read_outline(path: Path) -> Any:
    """Corners of an object from a file, which are not checked."""
    from planar_pushing.mechanics.outline.entries import SHAPES, outline_of_entry
    from planar_pushing.scenes.yaml_text import read_yaml

    content = read_yaml(path)
    if isinstance(content, dict) and not {*content} <= {*SHAPES}:
        entry = content.get("object")
        content = entry.get("outline") if isinstance(entry, dict) else None
    if content is None:
        allowed = "a list of corners [x, y], or a scene file with object.outline"
        raise InvalidFile(f"{path}: holds no outline; allowed: {allowed}; choose another file")
    if not isinstance(content, dict):
        return content
    try:
        return outline_of_entry(content)
    except InvalidValue as error:
        raise InvalidFile(f"{path}: {error}") from None


def chosen_pushes(args: argparse.Namespace) -> xr.Dataset:
    """Pushes of the file, or of one of its objects."""
    from planar_pushing.pushes.files import load_pushes
    from planar_pushing.pushes.logs.combine import of_object

    pushes = load_pushes(args.pushes)
    return pushes if args.object is None else of_object(pushes, args.object)


def table(rows: Sequence[Mapping[str, str | None]]) -> str:
    """Lines of a table from rows with a word for each column, or None; empty columns are left out.

    Words in the first column are left-aligned, numbers and all other columns right-aligned.
    """
    columns = dict.fromkeys(chain(*rows))
    names = [name for name in columns if any(row.get(name) is not None for row in rows)]
    cells = [names, *([row.get(name) or "" for name in names] for row in rows)]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    counted = all(re.match(r"-?\.?\d", row[0]) for row in cells[1:])
    first = str.rjust if counted else str.ljust
    lines = ([first(row[0], widths[0]), *map(str.rjust, row[1:], widths[1:])] for row in cells)
    return "\n".join("  ".join(line).rstrip() for line in lines)


#: Components of a vector below this, relative to the largest, are rounding errors.
ROUNDING = 1e-12


def numbers(values: Iterable[Any]) -> list[float]:
    """Components of a vector as plain numbers, without negative zeros."""
    return [float(value) + 0.0 for value in values]


def with_unit(name: str, unit: str) -> str:
    """Name of a quantity with its unit in brackets; "1" is the unit of numbers, flags and labels."""
    return name if unit == "1" else f"{name} [{unit}]"


def text(value: Any, indent: int = 0) -> str:
    """Readable lines of nested results."""
    if _is_nested(value):
        blocks = (
            f"{' ' * indent}{i}:\n{text(entry, indent + 2)}" for i, entry in enumerate(value, 1)
        )
        return "\n".join(blocks)
    if isinstance(value, dict):
        return "\n".join(_line(str(key), entry, indent) for key, entry in value.items())
    entries = value if isinstance(value, list) else [value]
    finite = [abs(v) for v in entries if isinstance(v, float) and math.isfinite(v)]
    smallest = ROUNDING * max(finite, default=0.0)
    return " ".join(_word(v, smallest) for v in entries)


def _word(value: Any, smallest: float) -> str:
    """Twelve digits of a number; 0 for a vector component that is only rounding error."""
    if value is None:
        return "none"
    return (
        f"{0.0 if abs(value) < smallest else value:.12g}"
        if isinstance(value, float)
        else str(value)
    )


def _is_nested(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _line(key: str, value: Any, indent: int) -> str:
    if _is_nested(value):
        return f"{' ' * indent}{key}:\n{text(value, indent + 2)}"
    return f"{' ' * indent}{key}: {text(value)}" if key else str(value)


@contextmanager
def naming_file(path: Path) -> Iterator[None]:
    """Name the file in a refusal of its content that only a computation can raise."""
    try:
        yield
    except InvalidValue as error:
        raise InvalidFile(f"{path}: {error}") from None
