"""Arguments that several commands take."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NoReturn

from planar_pushing.terms.errors import require_number, require_positive

#: Return type of `add_subparsers`, for which argparse has no public name.
Commands = Any
#: Function that runs a command with its arguments and returns the values to print.
Action = Callable[[argparse.Namespace], dict[str, Any]]

DIRECTION = (
    "degrees counterclockwise from the fence, any finite number; 90 is straight into the slider"
)


class Parser(argparse.ArgumentParser):
    """A parser that reports an error in the arguments in one line.

    Attributes
    ----------
    words : tuple of str
        Choices of its positional argument, for shell completion.
    values : mapping
        Choices by option, for shell completion.
    """

    words: tuple[str, ...] = ()
    values: Mapping[str, tuple[str, ...]] = {}

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        # Words that begin like a negative number are values, such as the range -90:90:5.
        self._negative_number_matcher = re.compile(r"-\.?\d")
        self.register("type", float, _number)
        self.register("type", int, _whole_number)

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} given; allowed: a number") from None


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
        given = tuple(map(float, text.split(":")))
        if len(given) == 1:
            return given[0]
        start, stop, step = given
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


def add_push(sub: argparse.ArgumentParser, ranges: bool) -> None:
    """Add the pusher's motion, whose angle can be a range."""
    metavar = "DEGREES|START:STOP:STEP" if ranges else "DEGREES"
    default = "that of the scene file" if ranges else "that of the scene file, or 90"
    size = "that of the file if its angle is used, or 1" if ranges else "that of the file, or 1"
    sub.add_argument(
        "--pusher-angle", type=angles if ranges else float, metavar=metavar,
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
        given = getattr(args, name, None)
        if given is not None and not isinstance(given, tuple):
            allowed = "a finite number of degrees"
            require_number(name, given, math.isfinite, allowed, "give one angle")
    magnitude = getattr(args, "pusher_magnitude", None)
    if magnitude is not None:
        require_positive("pusher_magnitude", magnitude, "use the angle to reverse the pusher")
