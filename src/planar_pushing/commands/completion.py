"""The command `completion`: shell completions, which shtab generates from the parser.

The script is static, so pressing the tab key does not start Python.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, Parser, command
from planar_pushing.terms.errors import require_name
from planar_pushing.terms.options import Method, Policy, Shape

#: Shells for which there is a script.
SHELLS = ("bash", "zsh", "fish", "tcsh", "powershell")
#: Choices of options of several commands.
VALUES = {
    "--method": tuple(Method),
    "--on-ambiguity": tuple(Policy),
    "--pusher-shape": tuple(Shape),
}


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print a shell script that completes the commands and their options."
    sub = command(commands, "completion", script, about, "bash > completion; . ./completion")
    sub.add_argument("shell", metavar="SHELL", help=f"{', '.join(SHELLS[:-1])} or {SHELLS[-1]}")
    sub.words = SHELLS


def script(args: argparse.Namespace) -> dict[str, Any]:
    """Completion script for a shell."""
    require_name("shell", args.shell, SHELLS, "name one of these shells")
    import shtab

    from planar_pushing.commands import parsers  # imports this module

    top, commands = parsers()
    for parser in commands.values():
        _add_completions(parser)
    return {"": shtab.complete(top, args.shell)}


def _add_completions(parser: Parser) -> None:
    """Give each argument of a parser the choices or the kind of file that shtab reads."""
    import shtab

    for option in parser.words:
        if option.startswith("--"):
            parser.add_argument(option)
    choices = VALUES | dict(parser.values)
    words: Any = [word for word in parser.words if not word.startswith("--")]
    for action in parser._actions:  # argparse has no public list of them
        if action.option_strings:
            chosen: Any = next((choices[o] for o in action.option_strings if o in choices), ())
        else:
            chosen, words = words, ()
        if isinstance(chosen, str):
            action.complete = shtab.cmd(chosen)  # type: ignore[attr-defined]
        elif chosen:
            action.choices = chosen
        elif action.type is Path:
            action.complete = shtab.FILE  # type: ignore[attr-defined]
