"""The golden check as on other processors: its environment, its summary, and tolerances that can hold."""

import json
import platform
import subprocess
import sys
from functools import cache

import numpy as np
import pytest
from evidence.golden.goldens import dataset_name, golden, names

from pulling_by_pushing.evidence.golden import processors
from pulling_by_pushing.evidence.golden.compare import load_tolerances
from pulling_by_pushing.evidence.golden.enclosures import holds_radii

#: Largest number that may be compared within an absolute tolerance alone, by unit.
LARGEST = {"degree": 720.0}
X86 = (sys.platform, platform.machine()) == ("linux", "x86_64")


@cache
def tolerated():
    """Numbers of the golden data without their infinities, and their tolerances and units."""
    tolerances, numbers = load_tolerances(), []
    for file, group in names():
        data, name = golden(file, group), dataset_name(file)
        for key in (key for key in map(str, data.variables) if not holds_radii(key, data)):
            if data[key].dtype.kind == "f":
                values = data[key].values[np.isfinite(data[key].values)]
                tolerance = tolerances.of(f"{name}/{group}" if group else name, key)
                if values.size and (tolerance.ulp or tolerance.absolute):
                    unit = data[key].attrs.get("units")
                    numbers.append((f"{name}: {key}", values, tolerance, unit))
    return numbers


def test_no_large_number_has_an_absolute_tolerance_alone():
    for name, values, tolerance, unit in tolerated():
        if not tolerance.ulp:
            assert np.abs(values).max() <= LARGEST.get(unit, 10.0), name
            if unit != "degree":
                continue
            assert tolerance.absolute >= np.spacing(np.abs(values).max()), name


def test_no_difference_near_zero_has_a_relative_tolerance_alone():
    for name, values, tolerance, _ in tolerated():
        sizes = np.abs(values)
        if not tolerance.absolute and "error" not in name:
            assert sizes.min() > 1e-6 * np.median(sizes) or not sizes.min(), name


def check(file, error=0.0, allowed=0.0, failed=0, problem=""):
    return {"file": file, "error": error, "allowed": allowed, "failed": failed, "problem": problem}


def test_the_summary_shows_the_largest_part_of_a_tolerance(tmp_path):
    checks = [
        check("one", 0.25e-12, 1e-12), check("one", 0.5e-12, 1e-12), check("labels"),
        check("flags", 1.0, failed=3), check("other", problem="cannot be read"),
        check("infinite", None, 1e-12, failed=1),
    ]  # fmt: skip
    path = tmp_path / "verdict.json"
    path.write_text(json.dumps({"checks": checks}), encoding="utf-8")
    used = processors.used_tolerances([path])
    inf = np.inf
    assert used == {"one": 0.5, "labels": 0.0, "flags": inf, "other": inf, "infinite": inf}
    lines = processors.table({"older": used, "native": {"one": 0.75}}).splitlines()
    assert lines[-2].split() == ["one", "0.5", "0.75"]


def test_another_processor_is_skipped_with_a_line(monkeypatch, capsys):
    monkeypatch.setattr(platform, "machine", lambda: "aarch64")
    monkeypatch.setattr(processors, "build", lambda *given: pytest.fail("is built"))
    assert processors.main() == 0
    assert "skipped" in capsys.readouterr().out


@pytest.mark.skipif(not X86, reason="the variables are about x86-64")
def test_the_variables_disable_what_numpy_found():
    variables = processors.older_processor()
    code = "import numpy as np; print(np.show_config(mode='dicts')['SIMD Extensions'].get('found', []))"
    found = subprocess.run(
        [sys.executable, "-c", code], env=variables, capture_output=True, text=True, check=True
    )
    assert found.stdout.strip() == "[]"


@pytest.mark.parametrize("failure", [True, False])
def test_a_build_that_differs_fails(monkeypatch, tmp_path, capsys, failure):
    if not X86:
        pytest.skip("only x86-64 is built twice")

    def build(name, variables):
        path = tmp_path / f"{name}.json"
        error = 2e-12 if failure and variables else 0.5e-12
        checks = [check("one", error, 1e-12, failed=int(error > 1e-12))]
        path.write_text(json.dumps({"checks": checks}), encoding="utf-8")
        return [path]

    monkeypatch.setattr(processors, "build", build)
    assert processors.main() == int(failure)
    assert ("FAILED: one" in capsys.readouterr().out) == failure
