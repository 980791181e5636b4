"""The directive `command-reference`: every command with its options, read from the parser."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from planar_pushing.commands import parser

#: Width of a usage line, in characters.
WIDTH = 84
#: Arguments that all commands share; the page describes them once.
SHARED = ("help", "json")


def commands() -> dict[str, argparse.ArgumentParser]:
    """Parser of each command, in the order of the help text."""
    # argparse has no public list of a parser's arguments.
    every = (action.choices for action in parser()._actions)
    return next(choices for choices in every if isinstance(choices, dict))


def arguments(command: argparse.ArgumentParser) -> Iterator[tuple[str, str]]:
    """Each argument of a command as it is typed, with its help; positional arguments first."""
    formatter = argparse.HelpFormatter(command.prog)
    options = (action for action in command._actions if action.dest not in SHARED)
    for action in sorted(options, key=lambda action: bool(action.option_strings)):
        yield formatter._format_action_invocation(action), formatter._expand_help(action)


def usage(command: argparse.ArgumentParser) -> str:
    """Usage line, wrapped at the same width on every terminal."""
    formatter = argparse.HelpFormatter(command.prog, width=WIDTH)
    groups = command._mutually_exclusive_groups
    formatter.add_usage(command.usage, command._actions, groups, prefix="")
    return formatter.format_help().rstrip()


def _code(text: str, language: str) -> nodes.literal_block:
    return nodes.literal_block(text, text, language=language)


def _definitions(command: argparse.ArgumentParser) -> nodes.definition_list:
    items = []
    for typed, about in arguments(command):
        term = nodes.term("", "", nodes.literal(typed, typed))
        meaning = nodes.definition("", nodes.paragraph(about, about))
        items.append(nodes.definition_list_item("", term, meaning))
    return nodes.definition_list("", *items, classes=["arguments"])


class CommandReference(SphinxDirective):
    """A section for each command."""

    def run(self) -> list[nodes.Node]:
        return [self._section(name, command) for name, command in commands().items()]

    def _section(self, name: str, command: argparse.ArgumentParser) -> nodes.section:
        label, about = f"command-{name}", command.description or ""
        section = nodes.section("", nodes.title(name, name), ids=[label], names=[label])
        section += nodes.paragraph(about, about)
        section += _code(usage(command), "text")
        section += [_definitions(command)] if list(arguments(command)) else []
        *before, example = (command.epilog or "").split("example: ")
        section += [_code(text.rstrip(), "text") for text in before if text]
        section += _code(f"$ {example}", "console")
        labels = self.env.domains.standard_domain
        labels.note_hyperlink_target(label, self.env.docname, label, f"planar-pushing {name}")
        return section


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("command-reference", CommandReference)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
