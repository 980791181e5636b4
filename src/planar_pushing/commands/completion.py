"""The command `completion`: what a shell completes, from the parser itself.

The script is static, so that pressing the tab key starts no Python and needs no package.
"""

from __future__ import annotations

import argparse
from typing import Any

from planar_pushing.commands import query
from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.study.catalog import DATASETS
from planar_pushing.terms.errors import InvalidValue
from planar_pushing.terms.options import Method, Policy

#: Lines that a shell needs before the function of bash; zsh runs such functions too.
SHELLS = {"bash": "", "zsh": "autoload -U +X compinit bashcompinit && compinit && bashcompinit\n"}
#: Values of options that take one of a few, and words of commands besides their options.
VALUES = {"--method": tuple(Method), "--on-ambiguity": tuple(Policy)}
WORDS = {
    "query": (
        *DATASETS,
        *sorted({query.option(axis) for entry in DATASETS.values() for axis in entry.dims}),
    ),
    "completion": tuple(SHELLS),
}
#: Files are completed where nothing else fits.
SCRIPT = """{start}_planar_pushing() {{
  local words=""
  case "${{COMP_WORDS[COMP_CWORD-1]}}" in
{values}
  esac
  if [ -z "$words" ]; then case "${{COMP_WORDS[1]}}" in
{commands}
    *) words="{first}" ;;
  esac; fi
  COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _planar_pushing planar-pushing"""


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Print a script that makes a shell complete the commands and their options."
    sub = command(commands, "completion", script, about, "bash > completion; . ./completion")
    sub.add_argument("shell", metavar="SHELL", help=f"{' or '.join(SHELLS)}")
    sub.set_defaults(known=commands.choices)


def script(args: argparse.Namespace) -> dict[str, Any]:
    """The script for a shell."""
    if args.shell not in SHELLS:
        raise InvalidValue("shell", args.shell, ", ".join(SHELLS), "name one of these shells")
    known: dict[str, argparse.ArgumentParser] = args.known
    return {
        "": SCRIPT.format(
            start=SHELLS[args.shell],
            values=_cases(VALUES),
            commands=_cases(
                {name: (*WORDS.get(name, ()), *_options(known[name])) for name in known}
            ),
            first=" ".join([*known, "--help", "--version"]),
        )
    }


def _options(parser: argparse.ArgumentParser) -> list[str]:
    """The options of a command."""
    # argparse has no public list of them.
    return [each for each in parser._option_string_actions if each.startswith("--")]


def _cases(words: dict[str, Any]) -> str:
    """Branches of a case statement: the words that follow each name."""
    return "\n".join(f'    {name}) words="{" ".join(each)}" ;;' for name, each in words.items())
