"""The command `plan`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from planar_pushing.commands.words import Commands, command, table

if TYPE_CHECKING:
    from pulling_by_pushing.study.running.plan import Plan

#: Columns of the table, each with the format of its value.
COLUMNS = {
    "dataset": "{0.dataset}",
    "points": "{0.points:,}",
    "chunks": "{0.chunks:,}",
    "jobs": "{0.jobs:,}",
    "MB a job": "{0.memory:,}",
    "MB of disk": "{0.disk:,.1f}",
    "CPU hours": "{0.cpu_hours:,.4f}",
}


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Estimate the cost of a study before running it: points, chunks, jobs, memory, disk space and CPU "
        "hours of each dataset. Rates are measured on this machine in a few seconds."
    )
    sub = command(commands, "plan", planned, about, "workflow/config/paper.yaml")
    sub.add_argument(
        "study",
        type=Path,
        metavar="STUDY.yaml",
        help="study file, which says what is computed and in which chunks",
    )


def planned(args: argparse.Namespace) -> dict[str, Any]:
    """The plan of each dataset, as a table."""
    from dataclasses import asdict

    from pulling_by_pushing.study.running.plan import study_plan, uncounted
    from pulling_by_pushing.study.study_file import load_study

    study = load_study(args.study)
    found, others = study_plan(study), uncounted(study)
    if args.json:
        return {"datasets": [asdict(each) for each in found], "not_counted": others}
    listed = ", ".join(_counted(count, name[:-1]) for name, count in others.items() if count)
    return {"": _table(found) + (f"\nnot counted: {listed}" if listed else "")}


def _table(found: list[Plan]) -> str:
    """Table with a line for each dataset, and the totals below."""
    rows = [{name: shape.format(each) for name, shape in COLUMNS.items()} for each in found]
    hours, disk = sum(each.cpu_hours for each in found), sum(each.disk for each in found)
    jobs = sum(each.jobs for each in found)
    total = f"{_counted(jobs, 'job')}, {hours:,.3f} CPU hours, {disk / 1e3:,.3f} GB of disk"
    return "\n".join([*([table(rows)] if rows else []), f"together: {total}"])


def _counted(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'s' * (number != 1)}"
