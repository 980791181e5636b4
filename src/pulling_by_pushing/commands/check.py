"""The command `check`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import InvalidFile, InvalidValue, number_of
from pulling_by_pushing.study.studies import (
    PAPER,
    PAPER_FILE,
    built_studies,
    file_name,
    project_file,
    study_file,
    study_folder,
)


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Check a results folder against the golden data of its study, or certify points of any study. "
        "The exit code is 0 if everything agrees, 1 if anything differs."
    )
    sub = command(commands, "check", check_study, about, "--json")
    sub.add_argument(
        "results", type=Path, nargs="?", default=Path("results"), metavar="RESULTS",
        help="results folder that the pipeline has written (default: results)",
    )  # fmt: skip
    sub.add_argument(
        "--study", metavar="STUDY.yaml",
        help="study file whose results are checked, or the name of a study of the project; results of a "
        f"study other than the paper's are in RESULTS/studies/NAME (default: {PAPER_FILE})",
    )  # fmt: skip
    sub.add_argument(
        "--points", type=int, metavar="N",
        help="enclose N random points of each dataset instead of comparing it with golden data; a whole "
        "number > 0",
    )  # fmt: skip


def check_study(args: argparse.Namespace) -> dict[str, Any]:
    """Return the verdict, and set `args.status` to 1 if anything differs."""
    from pulling_by_pushing.evidence.golden.check import check_results
    from pulling_by_pushing.evidence.golden.verdict import verdict, verdict_text

    file = _study(args)
    folder = study_folder(file_name(file), args.results)
    if args.points is None:
        content = verdict(check_results(folder, file))
    else:
        content = verdict(*_points(folder, file, args.points))
    args.status = 0 if content["passed"] else 1
    return content if args.json else {"": _without_agreement(verdict_text(content))}


def _study(args: argparse.Namespace) -> Path:
    """Study file to check; `--study` is required if the paper's study file is not in the current folder."""
    results: Path = args.results
    if not results.is_dir():
        remedy = "name the folder of the results, or build them with planar-pushing run STUDY.yaml"
        raise InvalidFile(f"{results}: no such folder; {remedy}")
    if args.study is not None:
        return study_file(args.study, results)
    others = built_studies(results)
    if others and not (results / "data").is_dir():
        remedy = "give the file of a study with --study"
        raise InvalidFile(f"{results}: holds results of {', '.join(others)} only; {remedy}")
    if (file := project_file(PAPER)) is None:
        remedy = "go to the project's folder, or give the file of a study with --study"
        raise InvalidFile(f"{PAPER_FILE}: no such file; {remedy}")
    return file


def _without_agreement(text: str) -> str:
    """Shorten the verdict: count the variables that agree instead of listing them."""
    lines = text.rstrip().splitlines()
    kept = [line for line in lines if not line.startswith("ok ")]
    agree = len(lines) - len(kept)
    agreeing = [f"{number_of(agree, 'variable')} agree; --json lists them"] if agree else []
    return "\n".join([*kept, *agreeing])


def _points(folder: Path, file: Path, number: int) -> Any:
    if number < 1:
        raise InvalidValue("points", number, "a whole number >= 1", "give more points")
    from planar_pushing.terms.extras import require_extra

    require_extra("golden")
    from pulling_by_pushing.evidence.golden.points import check_points

    return check_points(folder, file, number)
