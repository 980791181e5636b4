"""Run the tests with each change, in the folder of a copy, and print and write what became of it."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parents[2]
ROOMS = [
    f"tests/library/{room}" for room in ("core", "mechanics", "objects", "simulation", "stability")
]
RESULTS = "results.json"
sys.path.insert(0, str(FOLDER / "tests"))


class Core:
    """The switches of both forms of the core."""

    def __init__(self) -> None:
        from planar_pushing.core import _compiled, numbers
        from planar_pushing.mechanics.kernels import calls

        if calls.COMPILED is None:
            sys.exit("the copy has no compiled core")
        self.compiled, self.plain = _compiled, numbers

    def choose(self, number: int) -> None:
        """Choose a change; 0 is none."""
        self.compiled.choose(number)
        self.plain.MUTANT[0] = number

    def take_reached(self) -> list[int]:
        """The changes that were reached since the last call."""
        numbers = sorted({*self.compiled.take_reached(), *self.plain.REACHED})
        self.plain.REACHED.clear()
        return numbers


def main() -> None:
    """Try the changes."""
    from mutants.loop import Loop

    workers, only, caught, most = sys.argv[1:]
    changes = {each["number"]: each for each in json.loads((FOLDER / "changes.json").read_text())}
    numbers = [int(number) for number in only.split(",")] if only else [*changes]
    if caught:
        known = json.loads(Path(caught).read_text())
        numbers = [each["number"] for each in known if each["fate"].startswith("caught")]
    if unknown := [number for number in numbers if number not in changes]:
        sys.exit(f"--only: no change has the number {unknown[0]}; allowed: 1 to {len(changes)}")
    results, start = [], time.monotonic()

    def report(number: int, fate: str, cost: float) -> None:
        results.append(changes[number] | {"fate": fate, "seconds": round(cost, 1)})
        place = "{path}:{line} {function}: {old} -> {new}".format(**changes[number])
        print(f"{number} {place}\n    {fate} ({cost:.1f} s)", flush=True)
        ordered = sorted(results, key=lambda each: each["number"])
        (FOLDER / RESULTS).write_text(json.dumps(ordered, indent=1), encoding="utf-8")

    loop = Loop(numbers, int(workers), report, Core(), FOLDER / "baseline.jsonl", float(most))
    options = [
        "-p",
        "no:cacheprovider",
        "-p",
        "no:xdist",
        "--benchmark-disable",
        "-q",
        "--no-header",
    ]
    code = pytest.main([*options, *ROOMS], plugins=[loop])
    count = sum(each["fate"].startswith("caught") for each in results)
    missed = sorted(each["number"] for each in results if each["fate"].startswith("survives"))
    minutes = (time.monotonic() - start) / 60.0
    print(f"{count} of {len(results)} changes are caught; {minutes:.0f} min; {FOLDER / RESULTS}")
    print("not caught:", *missed)
    sys.exit(int(code not in (0, 5)))


if __name__ == "__main__":
    main()
