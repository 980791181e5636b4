"""The command `check`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.study.studies import PAPER_FILE, study_folder, study_name
from planar_pushing.terms.errors import InvalidFile, InvalidValue


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Check a results folder against the golden data of its study, or certify points of any study: "
        "0 where all agrees, 1 where something differs."
    )
    sub = command(commands, "check", checked, about, "--json")
    sub.add_argument(
        "results", type=Path, nargs="?", default=Path("results"), metavar="RESULTS",
        help="folder that the pipeline has filled (default: results)",
    )  # fmt: skip
    sub.add_argument(
        "--study", type=Path, default=Path(PAPER_FILE), metavar="STUDY.yaml",
        help="study whose results are checked, in RESULTS/studies/NAME for another than the paper's "
        f"(default: {PAPER_FILE})",
    )  # fmt: skip
    sub.add_argument(
        "--points", type=int, metavar="N",
        help="enclose N random points of each dataset, a whole number > 0, instead of comparing it with "
        "golden data",
    )  # fmt: skip


def checked(args: argparse.Namespace) -> dict[str, Any]:
    """The verdict; it sets `args.status` to 1 where anything differs."""
    from planar_pushing.evidence.golden.check import check_results
    from planar_pushing.evidence.golden.verdict import verdict, verdict_text

    if args.study == Path(PAPER_FILE) and not args.study.exists():
        remedy = "go to the project's folder, or give --study"
        raise InvalidFile(f"{PAPER_FILE}: no such file; {remedy}")
    folder = study_folder(study_name(args.study), args.results)
    if args.points is None:
        found = verdict(check_results(folder, args.study))
    else:
        found = verdict(*_points(folder, args))
    args.status = 0 if found["passed"] else 1
    return found if args.json else {"": verdict_text(found).rstrip()}


def _points(folder: Path, args: argparse.Namespace) -> Any:
    if args.points < 1:
        raise InvalidValue("points", args.points, "a whole number >= 1", "give more points")
    from planar_pushing.terms.extras import require_extra

    require_extra("golden")
    from planar_pushing.evidence.golden.points import check_points

    return check_points(folder, args.study, args.points)
