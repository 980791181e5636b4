"""The command `completion`: shell completions generated from the parser.

The script is static, so pressing the tab key does not start Python.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import Any

from planar_pushing.commands import convert, identify, query
from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.study.catalog import DATASETS, opened
from planar_pushing.study.studies import PAPER
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import EffectSet, Method, Policy, Shape

#: Lines that a shell needs before the bash function, which zsh can also run.
SHELLS = {"bash": "", "zsh": "autoload -U +X compinit bashcompinit && compinit && bashcompinit\n"}
AXES = sorted({query.option(axis) for entry in DATASETS.values() for axis in entry.dims})
#: Values of options with a fixed set of choices, by command and option; studies are those already built.
VALUES = {
    "* --method": tuple(Method),
    "* --on-ambiguity": tuple(Policy),
    "* --pusher-shape": tuple(Shape),
    "identify --family": tuple(identify.FAMILIES),
    "query --effects": tuple(EffectSet),
    "query --study": (PAPER, "$(ls results/studies 2>/dev/null)"),
}
#: Positional arguments of commands that have a fixed set of choices.
WORDS = {
    "query": (*(name for name in opened() if not name.endswith("/NAME")), *AXES),
    "completion": tuple(SHELLS),
    "convert": tuple(convert.FORMATS),
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
    sub.set_defaults(known=commands.choices)


def script(args: argparse.Namespace) -> dict[str, Any]:
    """Completion script for a shell."""
    if args.shell not in SHELLS:
        raise InvalidValue("shell", args.shell, ", ".join(SHELLS), "name one of these shells")
    known: dict[str, argparse.ArgumentParser] = args.known
    return {
        "": SCRIPT.format(
            start=SHELLS[args.shell],
            values=_cases({_pattern(name): each for name, each in VALUES.items()}),
            others="|".join(f'*" {name}"' for name in sorted({*AXES, *_taking(known.values())})),
            commands=_cases(
                {name: (*WORDS.get(name, ()), *_options(known[name])) for name in known}
            ),
            first=" ".join([*known, "--help", "--version"]),
        )
    }


def _options(parser: argparse.ArgumentParser) -> list[str]:
    """The options of a command."""
    # argparse has no public list of the options.
    return [each for each in parser._option_string_actions if each.startswith("--")]


def _taking(parsers: Iterable[argparse.ArgumentParser]) -> set[str]:
    """Options of all commands that take a value."""
    actions = [each for parser in parsers for each in parser._option_string_actions.items()]
    return {name for name, action in actions if action.nargs != 0}


def _pattern(name: str) -> str:
    """Shell pattern for a command and an option; `*` matches any command."""
    command, option = name.split()
    return f'*" {option}"' if command == "*" else f'"{name}"'


def _cases(words: dict[str, Any]) -> str:
    """Branches of a shell case statement, with the words that can follow each name."""
    return "\n".join(f'    {name}) words="{" ".join(each)}" ;;' for name, each in words.items())
