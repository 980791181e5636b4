"""The command `run`."""

from __future__ import annotations

import argparse
import os
import shlex
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

import pulling_by_pushing
from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import InvalidFile, InvalidValue
from planar_pushing.terms.signals import Termination

#: Locations of the workflow: inside an installed package, or at the top of a checkout.
PLACES = (".", "../..")


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = (
        "Build a study with Snakemake, in the current folder. Missing and outdated results are written to "
        "RESULTS/studies/NAME, where NAME is the name of the study file. Needs the extra workflow."
    )
    sub = command(commands, "run", run_study, about, "my_folder/my_study.yaml --cores 2")
    about = "study file, which says what is computed and drawn"
    sub.add_argument("study", type=Path, metavar="STUDY.yaml", help=about)
    sub.add_argument(
        "--results", type=Path, default=Path("results"), metavar="FOLDER",
        help="folder of all results (default: results)",
    )  # fmt: skip
    sub.add_argument(
        "--cores", type=int, metavar="NUMBER",
        help="cores that jobs may use, a whole number >= 1 (default: all)",
    )  # fmt: skip
    sub.add_argument("--dry-run", action="store_true", help="print the jobs without running them")


def run_study(args: argparse.Namespace) -> dict[str, Any]:
    """Return the location of the results, and set `args.status` to 1 if a job fails."""
    if args.cores is not None and args.cores < 1:
        raise InvalidValue("cores", args.cores, "a whole number >= 1", "leave it out for all cores")
    name, folder = _require_study(args)
    args.status = _snakemake(args)
    if args.status:
        return {"results": str(folder), "built": "incomplete; see the lines above"}
    if args.dry_run:
        return {"results": str(folder), "built": "nothing (dry run)"}
    elsewhere = [] if args.results == Path("results") else ["--results", str(args.results)]
    listing = shlex.join(["planar-pushing", "query", "--study", name, *elsewhere])
    return {"results": str(folder), "to list its datasets": listing}


def _require_study(args: argparse.Namespace) -> tuple[str, Path]:
    """Name and folder of a valid study; Snakemake itself would report an error in many lines."""
    from planar_pushing.terms.extras import require_extra
    from pulling_by_pushing.study.studies import (
        KEY,
        RESULTS,
        chosen_results,
        chosen_study,
        study_folder,
        study_name,
    )

    config = {KEY: str(args.study), RESULTS: str(args.results)}
    chosen_study(config)
    name, folder = study_name(args.study), Path(chosen_results(config))
    for extra in ("workflow", "figures"):
        require_extra(extra)
    from pulling_by_pushing.figures.studies import load_drawn_study

    if load_drawn_study(args.study).chunks:
        require_extra("chunks")
    return name, study_folder(name, folder)


def snakefile() -> Path:
    """Path of the Snakefile of this package."""
    package = Path(pulling_by_pushing.__path__[0])
    candidates = [(package / folder / "Snakefile").resolve() for folder in PLACES]
    if existing := [path for path in candidates if path.is_file()]:
        return existing[0]
    raise InvalidFile(f"{candidates[0]}: no such file; reinstall planar-pushing")


def config_path(path: Path) -> str:
    """A path in Snakemake's configuration, where 2026 is a number, even in quotation marks."""
    text = str(path)
    is_word = text in ("True", "False")
    with suppress(ValueError):
        float(text)
        is_word = True
    return f"./{text}" if is_word else text


def _snakemake(args: argparse.Namespace) -> int:
    """Run Snakemake, which handles Ctrl-C and ends its own jobs; return the exit code.

    The terminal sends Ctrl-C to Snakemake and its jobs, too. SIGTERM is passed on to them.
    """
    file = snakefile()
    words = [
        *(
            "--snakefile",
            str(file),
            "--workflow-profile",
            str(file.parent / "workflow/profiles/default"),
        ),
        *(("--cores", str(args.cores)) if args.cores else ()),
        *(("--dry-run",) if args.dry_run else ()),
        "--config",
        *(f"{key}={config_path(getattr(args, key))}" for key in ("study", "results")),
    ]
    environment = {key: value for key, value in os.environ.items() if key != "SNAKEMAKE_PROFILE"}
    heard: list[int] = []

    def hear(number: int, _: object) -> None:
        heard.append(number)
        if number == signal.SIGTERM:
            _terminate_children()

    before = {number: signal.signal(number, hear) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        status = subprocess.run(
            [sys.executable, "-m", "snakemake", *words], env=environment, check=False,
            stdout=2 if args.json else None,
        ).returncode  # fmt: skip
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if heard:
        raise Termination if signal.SIGTERM in heard else KeyboardInterrupt
    return int(bool(status))


def _terminate_children() -> None:
    """Send SIGTERM to Snakemake and its jobs; Snakemake alone would wait for them."""
    import psutil  # type: ignore[import-untyped]  # a dependency of Snakemake

    for process in psutil.Process().children(recursive=True):
        with suppress(psutil.Error):
            process.terminate()
