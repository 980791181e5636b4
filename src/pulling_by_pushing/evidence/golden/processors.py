"""Golden check of both studies as on an older processor, and with all features of this one.

Elementary functions of the C library and of numpy, and sums of BLAS, differ in the last digits between
processors. `make test-processors` builds the results that have golden data twice, without AVX2 and FMA and
with everything that this machine has, and prints the part of its tolerance that each dataset uses.
"""

from __future__ import annotations

import json
import os
import platform
import shutil
import subprocess
import sys
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from pulling_by_pushing.evidence.golden.verdict import used_tolerance
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE, study_folder, study_name

#: Folder of the results of both builds.
BUILDS = Path("build/processors")
#: Features without which the C library computes as on an older processor.
WITHOUT = ("AVX2", "FMA", "FMA4", "AVX512F")
OLDER, NATIVE = "older", "native"

#: Largest part of a tolerance that is used, by result; infinite if a comparison was not possible.
Ratios = dict[str, float]


def older_processor() -> dict[str, str]:
    """Environment variables with which this machine computes as an x86-64 processor without AVX2."""
    simd: Mapping[str, Any] = np.show_config(mode="dicts")["SIMD Extensions"]
    return {
        "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={','.join(f'-{name}' for name in WITHOUT)}",
        "NPY_DISABLE_CPU_FEATURES": " ".join(simd.get("found", [])),
        "OPENBLAS_CORETYPE": "Nehalem",
    }


def build(name: str, variables: Mapping[str, str]) -> list[Path]:
    """Build the results that have golden data in an empty folder, and return the files of the verdicts."""
    folder, environment = BUILDS / name, os.environ | variables
    shutil.rmtree(folder, ignore_errors=True)
    studies = (study_folder(study_name(file), folder) for file in (PAPER_FILE, SLIDERS_FILE))
    verdicts = [study / "tables/golden_verdict.json" for study in studies]
    snakemake = [sys.executable, "-m", "snakemake", *map(str, verdicts)]
    command = [*snakemake, "--config", f"results={json.dumps(str(folder))}"]
    subprocess.run(command, env=environment, check=True, stderr=None)
    return verdicts


def used_tolerances(verdicts: list[Path]) -> Ratios:
    """The largest part of its tolerance that each result uses."""
    ratios: Ratios = defaultdict(float)
    for path in verdicts:
        for check in json.loads(path.read_text(encoding="utf-8"))["checks"]:
            ratios[check["file"]] = max(ratios[check["file"]], used_tolerance(check))
    return ratios


def table(ratios: Mapping[str, Ratios]) -> str:
    """The parts of the tolerances by result, the largest first."""
    names = {name for parts in ratios.values() for name in parts}
    worst = {name: max(parts.get(name, 0.0) for parts in ratios.values()) for name in names}
    head = "".join(f"{name:>12}" for name in ratios)
    lines = [f"{'largest difference / tolerance':<40}{head}"]
    for name in sorted(names, key=lambda result: (-worst[result], result)):
        row = "".join(f"{parts.get(name, np.nan):>12.2g}" for parts in ratios.values())
        lines.append(f"{name:<40}{row}")
    return "\n".join(lines)


def main() -> int:
    """Build twice, print the table, and return 1 if a check failed."""
    if (sys.platform, platform.machine()) != ("linux", "x86_64"):
        print("test-processors: skipped; it needs Linux on an x86-64 processor")
        return 0
    variables: dict[str, dict[str, str]] = {OLDER: older_processor(), NATIVE: {}}
    ratios: dict[str, Ratios] = {}
    for name, environment in variables.items():
        print(f"Building as on {name} processors:", environment or "all features", flush=True)
        ratios[name] = used_tolerances(build(name, environment))
    print(table(ratios))
    failed = sorted(
        {name for parts in ratios.values() for name, used in parts.items() if not used <= 1.0}
    )
    print(
        f"FAILED: {', '.join(failed)}" if failed else "passed: both builds agree with golden data"
    )
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(run_command(main))
