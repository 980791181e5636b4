"""Digests of the golden files of a folder, in a file that `sha256sum --check` reads, too.

`make golden WRITE=1` lists the digest of each file that it stores, so that a golden file that was changed
by hand, or lost a part, is no golden file. Run as a program, the module lists the files of both studies
anew, for golden files that come from somewhere else, such as a merge.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile
from pulling_by_pushing.evidence.writing import write_text
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.slices import result_names
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE
from pulling_by_pushing.study.study_file import load_study

#: Name of the list in a folder of golden data.
DIGESTS = "SHA256SUMS"
#: What to do about a golden file that is not as it was stored.
REMEDY = "take it from the repository, or write it again with make golden WRITE=1"


def digest(path: Path) -> str:
    """SHA-256 of a file, in hexadecimal digits."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def read_digests(golden: Path) -> dict[str, str]:
    """Digests of the golden files that a folder lists, by the names of their results.

    Raises
    ------
    InvalidFile
        If the list is missing or has a line that is no digest of a file.
    """
    path = golden / DIGESTS
    if not path.is_file():
        raise InvalidFile(f"{path}: no such list of digests; {REMEDY}")
    digests = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        number, gap, name = line.partition("  ")
        if len(number) != 64 or not gap or not name.endswith(".nc"):
            raise InvalidFile(f"{path}: {line[:80]!r} is no digest of a golden file; {REMEDY}")
        digests[name.removesuffix(".nc")] = number
    return digests


def changed_files(golden: Path, names: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Names of the results whose golden files are not as they were stored, each with the problem."""
    digests = read_digests(golden)
    for name in names:
        file = golden / f"{name}.nc"
        if name not in digests:
            yield name, f"is a golden file that {golden / DIGESTS} does not list; {REMEDY}"
        elif digest(file) != digests[name]:
            yield name, f"{file} is not the golden file of {golden / DIGESTS}; {REMEDY}"


def list_digests(golden: Path, names: Iterable[str]) -> None:
    """List the digests of some golden files, and keep those of the other ones that exist."""
    listed = read_digests(golden) if (golden / DIGESTS).is_file() else {}
    digests = {name: number for name, number in listed.items() if (golden / f"{name}.nc").is_file()}
    digests |= {name: digest(golden / f"{name}.nc") for name in names}
    lines = [f"{number}  {name}.nc\n" for name, number in sorted(digests.items())]
    write_text("".join(lines), golden / DIGESTS)


def main() -> int:
    """List the golden files of both studies."""
    for file in (PAPER_FILE, SLIDERS_FILE):
        study = load_study(file)
        golden = Path(study.golden or "")
        list_digests(golden, result_names(study))
        print(f"{golden / DIGESTS}: {len(read_digests(golden))} files")
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main))
