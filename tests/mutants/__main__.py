"""Change the core in a hundred places, one at a time, and see which changes its tests notice.

``python tests/mutants FOLDER`` copies the project into a folder, compiles there one library that has all
changes as switches, and writes ``results.json`` and a table. The tests are the fast ones of the core, the
mechanics, the objects, the simulation and the stability.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main() -> None:
    """Read the arguments; build, then run in a process that imports the copy."""
    parser = argparse.ArgumentParser(description=__doc__, prog="python tests/mutants")
    parser.add_argument("folder", type=Path, help="where the copy of the project is made")
    parser.add_argument("--seed", type=int, default=1, help="which changes (a whole number)")
    parser.add_argument("--count", type=int, default=100, help="how many changes (a whole number)")
    parser.add_argument("--only", metavar="N,N,...", help="the numbers of the changes to try")
    parser.add_argument(
        "--caught", type=Path, metavar="FILE", help="try those caught in these results"
    )
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="tests at a time")
    parser.add_argument("--seconds", type=float, default=60.0, help="for each change (s)")
    parser.add_argument(
        "--tests", action="store_true", help="keep the library, copy only the tests"
    )
    options = parser.parse_args()
    if not all(number.strip().isdigit() for number in (options.only or "1").split(",")):
        parser.error(f"--only: {options.only} given; allowed: numbers with commas between them")
    folder = options.folder.resolve()
    sys.path.insert(0, str(HERE.parent))
    from mutants.switches import build_mutants, copy_tests, is_free

    if not is_free(folder):
        parser.error(f"{folder} has other files; allowed: a new or an empty folder, or an old copy")
    folder.mkdir(parents=True, exist_ok=True)
    if options.tests:
        copy_tests(folder)
    else:
        build_mutants(folder, options.seed, options.count)
    command = [sys.executable, str(folder / "tests/mutants/trial.py"), str(options.workers)]
    command += [options.only or "", str(options.caught.resolve()) if options.caught else ""]
    command += [str(options.seconds)]
    names = ("PLANAR_PUSHING_PLAIN", "PYTEST_ADDOPTS")
    environment = {name: value for name, value in os.environ.items() if name not in names}
    environment |= {"PYTHONPATH": str(folder / "src"), "OPENBLAS_NUM_THREADS": "1"}
    sys.exit(subprocess.run(command, cwd=folder, env=environment, check=False).returncode)


if __name__ == "__main__":
    main()
