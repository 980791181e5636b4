"""The command line, with the names of the Python interface."""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import threading
import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from importlib.metadata import entry_points
from typing import Any

from planar_pushing import __version__
from planar_pushing.commands import (
    animate,
    assess,
    compare,
    completion,
    cone,
    convert,
    draw,
    explore,
    identify,
    schema,
    simulate,
    solve,
)
from planar_pushing.commands.words import Parser, check_push, text
from planar_pushing.terms.errors import (
    EarlyEndWarning,
    InvalidValue,
    PlainCoreWarning,
    PlanarPushingError,
    SceneWarning,
    suggestion,
)
from planar_pushing.terms.locks import regular_file
from planar_pushing.terms.signals import Termination, termination_as_interrupt

#: Group of the entry points of other packages' commands, each a module with a function `add`. Help, version
#: and completion import all of these modules, so none imports numpy before its command runs.
GROUP = "planar_pushing.commands"
COMMANDS = (
    solve,
    cone,
    draw,
    explore,
    simulate,
    assess,
    animate,
    convert,
    identify,
    compare,
    schema,
    completion,
)
#: How Python prints a warning: with file and line, which are not those of a user of the command line.
SHOW = warnings.showwarning
#: Exit codes other than 0, by shell convention: invalid input, Ctrl-C, a closed output pipe, and SIGTERM.
INVALID, INTERRUPTED, UNREAD, TERMINATED = 2, 130, 141, 143


def parser() -> Parser:
    """The parser of all commands."""
    return parsers()[0]


def parsers() -> tuple[Parser, dict[str, Parser]]:
    """The parser of all commands, and the parser of each by its name."""
    top = Parser(prog="planar-pushing", description=__doc__, allow_abbrev=False)
    top.add_argument("--version", action="version", version=f"planar-pushing {__version__}")
    commands = top.add_subparsers(dest="command", required=True, metavar="command")
    for module in (*COMMANDS, *(entry.load() for entry in sorted(entry_points(group=GROUP)))):
        module.add(commands)
    return top, commands.choices


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return 0, 1 if a check fails, or 2 with a message if the input is invalid."""
    sys.unraisablehook = _repeat_interrupt
    _open_closed_streams()
    with termination_as_interrupt():
        return _run_to_end(arguments)


def _run_to_end(arguments: Sequence[str] | None) -> int:
    """Run the command line; however it ends, in an exit code and at most one line."""
    try:
        try:
            return _run(arguments)
        finally:
            sys.stdout.flush()
    except Termination:
        print("planar-pushing: terminated", file=sys.stderr)
        return TERMINATED
    except KeyboardInterrupt:
        print("planar-pushing: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _discard_output()
        return UNREAD
    except OSError as error:
        _discard_output()
        file = f"{error.filename}: " if error.filename else ""
        print(f"planar-pushing: {file}{error.strerror or error}", file=sys.stderr)
        return INVALID


def _run(arguments: Sequence[str] | None) -> int:
    words = sys.argv[1:] if arguments is None else list(arguments)
    top, commands = parsers()
    _check_words(words, top, commands)
    others: list[str] = []
    if words and words[0] in commands:
        known, others = commands[words[0]].split(words[1:])
        words = [words[0], *known]
    args, rest = top.parse_known_args(words)
    if not commands[args.command].open:
        commands[args.command].require_no_more(rest)
    args.where, args.status = [*others, *rest], 0  # a command can set the status
    try:
        with warnings.catch_warnings():
            warnings.showwarning = partial(_show_warning, args.command)
            return _answer(args)
    except PlanarPushingError as error:
        print(f"planar-pushing {args.command}: {error}", file=sys.stderr)
        return INVALID


def _show_warning(
    command: str, message: Warning | str, category: type[Warning], *where: Any, **options: Any
) -> None:
    """Print a warning of the package as one line, and any other one as Python does."""
    if issubclass(category, (EarlyEndWarning, PlainCoreWarning, SceneWarning)):
        text = " ".join(str(message).splitlines())
        print(f"planar-pushing {command}: {category.__name__}: {text}", file=sys.stderr)
    else:
        SHOW(message, category, *where, **options)


def _answer(args: argparse.Namespace) -> int:
    """Run a command, print its result, and return its status."""
    check_push(args)
    _check_output(args)
    _print(args.action(args), args.json)
    return int(args.status)


def _check_words(words: Sequence[str], top: Parser, commands: Mapping[str, Parser]) -> None:
    """Reject a mistyped command or option, and suggest a similar one."""
    name = words[0] if words else "--"
    if name in commands:
        commands[name].require_known(words[1:])
        commands[name].require_once(words[1:])
    elif not name.startswith("-"):
        remedy = suggestion(name, commands, "choose one of these")
        top.error(f"{name!r} given; allowed: {', '.join(commands)}; {remedy}")
    else:
        top.require_known(words[:1])


def _check_output(args: argparse.Namespace) -> None:
    """Reject an output file in a missing folder, whose path may be mistyped, or in a file, and a device."""
    output = getattr(args, "output", None)
    if output is not None and not output.parent.is_dir():
        create = f"create the folder {output.parent}, or " if not output.parent.exists() else ""
        remedy = f"{create}choose another file"
        raise InvalidValue("output", str(output), "a file in an existing folder", remedy)
    if output is not None:
        regular_file(output)


def _print(result: dict[str, object], as_json: bool) -> None:
    if as_json:
        from planar_pushing.mechanics.entries import plain

        print(json.dumps(plain(result), indent=2))
    else:
        print(text(result))


def _repeat_interrupt(dropped: sys.UnraisableHookArgs) -> None:
    """Send a signal again if it came in a destructor or a callback, where Python drops what it raises."""
    if issubclass(dropped.exc_type, KeyboardInterrupt):
        is_termination = issubclass(dropped.exc_type, Termination)
        number = signal.SIGTERM if is_termination else signal.SIGINT
        threading.Timer(0.01, os.kill, [os.getpid(), number]).start()
    else:
        sys.__unraisablehook__(dropped)


def _discard_output() -> None:
    """Discard pending output, which Python would otherwise try to write again on exit."""
    with suppress(OSError):  # an output that is not backed by a file
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _open_closed_streams() -> None:
    """Open the null device in the place of each standard stream that is closed, as cron jobs close them.

    Otherwise the next file that is opened takes its place, and receives what is printed.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        if getattr(sys, name) is None:
            stream = open(os.devnull, "r+" if number else "r", encoding="utf-8")  # noqa: PTH123, SIM115
            setattr(sys, name, stream)
            with suppress(OSError):
                os.fstat(number)
                continue
            os.dup2(stream.fileno(), number)
