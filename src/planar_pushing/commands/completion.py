"""The command `completion`: shell completions generated from the parser.

The script is static, so pressing the tab key does not start Python.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import Any

from planar_pushing.commands.words import Commands, Parser, command
from planar_pushing.terms.errors import require_name
from planar_pushing.terms.options import Method, Policy, Shape

#: Lines that a shell needs before the bash function, which zsh can also run.
SHELLS = {"bash": "", "zsh": "autoload -U +X compinit bashcompinit && compinit && bashcompinit\n"}
#: Choices of options of several commands.
VALUES = {
    "--method": tuple(Method),
    "--on-ambiguity": tuple(Policy),
    "--pusher-shape": tuple(Shape),
}
#: Files are completed where nothing else fits, and after an option that takes a free value.
SCRIPT = """{start}_planar_pushing() {{
  local words=""
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{values}
    {others}) COMPREPLY=(); return ;;
    *) case "${{COMP_WORDS[1]}}" in
{commands}
    *) words="{first}" ;;
    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _planar_pushing planar-pushing"""


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print a shell script that completes the commands and their options."
    sub = command(commands, "completion", script, about, "bash > completion; . ./completion")
    sub.add_argument("shell", metavar="SHELL", help=f"{' or '.join(SHELLS)}")
    sub.words = tuple(SHELLS)
    sub.set_defaults(known=commands.choices)


def script(args: argparse.Namespace) -> dict[str, Any]:
    """Completion script for a shell."""
    require_name("shell", args.shell, SHELLS, "name one of these shells")
    known: dict[str, Parser] = args.known
    values: dict[str, tuple[str, ...]] = {
        f'*" {option}"': words for option, words in VALUES.items()
    }
    for name, parser in known.items():
        values |= {f'"{name} {option}"': words for option, words in parser.values.items()}
    return {
        "": SCRIPT.format(
            start=SHELLS[args.shell],
            values=_cases(values),
            others="|".join(f'*" {name}"' for name in sorted(_options_with_values(known.values()))),
            commands=_cases(
                {name: (*parser.words, *parser.options) for name, parser in known.items()}
            ),
            first=" ".join([*known, "--help", "--version"]),
        )
    }


def _options_with_values(parsers: Iterable[Parser]) -> set[str]:
    """Options of all commands that take a value."""
    parsers = list(parsers)
    actions = [entry for parser in parsers for entry in parser._option_string_actions.items()]
    words = {word for parser in parsers for word in parser.words if word.startswith("--")}
    return words | {name for name, action in actions if action.nargs != 0}


def _cases(words: dict[str, Any]) -> str:
    """Branches of a shell case statement, with the words that can follow each name."""
    return "\n".join(
        f'    {name}) words="{" ".join(choices)}" ;;' for name, choices in words.items()
    )
