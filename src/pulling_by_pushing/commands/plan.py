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
    sub = command(commands, "plan", plan_study, about, "workflow/config/paper.yaml")
    sub.add_argument(
        "study",
        type=Path,
        metavar="STUDY.yaml",
        help="study file, which says what is computed and in which chunks",
    )


def plan_study(args: argparse.Namespace) -> dict[str, Any]:
    """The plan of each dataset, as a table."""
    from dataclasses import asdict

    from pulling_by_pushing.study.running.plan import counts_beyond_grids, study_plan
    from pulling_by_pushing.study.study_file import load_study

    study = load_study(args.study)
    plans, uncounted = study_plan(study), counts_beyond_grids(study)
    if args.json:
        return {"datasets": [asdict(plan) for plan in plans], "not_counted": uncounted}
    listed = ", ".join(_count_text(count, name[:-1]) for name, count in uncounted.items() if count)
    return {"": _table(plans) + (f"\nnot counted: {listed}" if listed else "")}


def _table(plans: list[Plan]) -> str:
    """Table with a line for each dataset, and the totals below."""
    rows = [{name: shape.format(plan) for name, shape in COLUMNS.items()} for plan in plans]
    hours, disk = sum(plan.cpu_hours for plan in plans), sum(plan.disk for plan in plans)
    jobs = sum(plan.jobs for plan in plans)
    total = f"{_count_text(jobs, 'job')}, {hours:,.3f} CPU hours, {disk / 1e3:,.3f} GB of disk"
    return "\n".join([*([table(rows)] if rows else []), f"together: {total}"])


def _count_text(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'s' * (number != 1)}"
