"""planar-pushing check: every value of a results folder against equations and golden data."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.arguments import Commands, command


def add(commands: Commands) -> None:
    """Add the command."""
    about = "Check every value of a results folder: 0 where all agrees, 1 where something differs."
    sub = command(commands, "check", checked, about, "--json")
    sub.add_argument(
        "results", type=Path, nargs="?", default=Path("results"), metavar="RESULTS",
        help="folder of the results (default: results)",
    )  # fmt: skip
    sub.add_argument(
        "--study", type=Path, default=Path("workflow/config/paper.yaml"), metavar="STUDY.yaml",
        help="study that the results are of (default: workflow/config/paper.yaml)",
    )  # fmt: skip


def checked(args: argparse.Namespace) -> dict[str, Any]:
    """The verdict; it sets `args.status` to 1 where anything differs."""
    from planar_pushing.evidence.golden.check import check_results
    from planar_pushing.evidence.golden.verdict import verdict, verdict_text
    from planar_pushing.study.study_file import load_study

    found = verdict(check_results(args.results, load_study(args.study)))
    args.status = 0 if found["passed"] else 1
    return found if args.json else {"": verdict_text(found).rstrip()}
