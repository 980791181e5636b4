"""The command `check`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words.arguments import Commands, command
from planar_pushing.study.studies import (
    PAPER_FILE,
    built_studies,
    file_name,
    paper_file,
    study_folder,
)
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
        "--study", type=Path, metavar="STUDY.yaml",
        help="file of the study whose results are checked, in RESULTS/studies/NAME for another than the "
        f"paper's (default: {PAPER_FILE})",
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

    file = _study(args)
    folder = study_folder(file_name(file), args.results)
    if args.points is None:
        found = verdict(check_results(folder, file))
    else:
        found = verdict(*_points(folder, file, args.points))
    args.status = 0 if found["passed"] else 1
    return found if args.json else {"": _short(verdict_text(found))}


def _study(args: argparse.Namespace) -> Path:
    """The file of the study that is checked, which `--study` has to name where the paper's is elsewhere."""
    results: Path = args.results
    if not results.is_dir():
        remedy = "name the folder of the results, or build them with planar-pushing run STUDY.yaml"
        raise InvalidFile(f"{results}: no such folder; {remedy}")
    if args.study is not None:
        return Path(args.study)
    others = built_studies(results)
    if others and not (results / "data").is_dir():
        remedy = "give the file of a study with --study"
        raise InvalidFile(f"{results}: holds results of {', '.join(others)} alone; {remedy}")
    if (file := paper_file()) is None:
        remedy = "go to the project's folder, or give the file of a study with --study"
        raise InvalidFile(f"{PAPER_FILE}: no such file; {remedy}")
    return file


def _short(text: str) -> str:
    """The verdict without a line for each variable that agrees."""
    lines = text.rstrip().splitlines()
    kept = [line for line in lines if not line.startswith("ok ")]
    agree = len(lines) - len(kept)
    return "\n".join([*kept, *([f"{agree} variables agree; --json lists them"] if agree else [])])


def _points(folder: Path, file: Path, number: int) -> Any:
    if number < 1:
        raise InvalidValue("points", number, "a whole number >= 1", "give more points")
    from planar_pushing.terms.extras import require_extra

    require_extra("golden")
    from planar_pushing.evidence.golden.points import check_points

    return check_points(folder, file, number)
