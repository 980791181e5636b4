"""The C compiler: its command, the options that keep the bits of the source, and a test of what it made."""

from __future__ import annotations

import contextlib
import functools
import importlib
import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

#: Undo the options of CC that would change results, or would flush subnormal numbers of the whole process.
FLAGS = (
    "-fno-fast-math -fno-unsafe-math-optimizations -fno-associative-math -fno-reciprocal-math "
    "-fno-finite-math-only -fsigned-zeros "
)
#: Results do not depend on the processor: no fused multiply-add, and only instructions that all have.
FLAGS += (
    "-std=c11 -O3 -fno-trapping-math -fPIC -ffp-contract=off -fno-tree-vectorize "
    "-fno-tree-slp-vectorize -fno-math-errno -w"
)
if platform.machine() in ("x86_64", "AMD64"):
    # Records are copied number by number: a wider load has to wait for the narrow stores before it.
    FLAGS += " -mtune=core2"
#: Free-threaded Python has no stable binary interface for libraries.
STABLE = not sysconfig.get_config_var("Py_GIL_DISABLED")

#: In a process of its own: a library that flushes subnormal numbers does so for all of its process.
PROBE = """
import importlib.util, runpy, sys
spec = importlib.util.spec_from_file_location("_compiled", sys.argv[1])
compiled = importlib.util.module_from_spec(spec)
spec.loader.exec_module(compiled)
sys.exit(not runpy.run_path(sys.argv[2])["keeps_bits"](compiled.probe))
"""


class CompileFailure(Exception):
    """The core cannot be compiled; the message says why."""


def cython_version() -> str:
    """The version of Cython."""
    if importlib.util.find_spec("Cython") is None:
        raise CompileFailure("no Cython")
    return str(importlib.import_module("Cython").__version__)


def compiler() -> list[str]:
    """The C compiler of this Python, or the one of the variable CC, with its options."""
    given = os.environ.get("CC")
    commands = [given] if given else [sysconfig.get_config_var("CC") or "cc", "cc", "gcc", "clang"]
    for command in commands:
        with contextlib.suppress(ValueError):  # a quotation without an end
            words = shlex.split(command)
            if words and shutil.which(words[0]):
                return words
    raise CompileFailure(f"no C compiler ({commands[0]} not found)")


@functools.cache
def compiler_version(*command: str) -> str:
    """What a compiler says of its version; nothing if it has no such option."""
    try:
        return _run([*command, "--version"]).stdout
    except OSError:
        return ""


def compile_library(text: str, folder: Path, known: Path) -> Path:
    """Compile the text of a Cython module in a folder, and compare what it computes with known results."""
    words = compiler()
    include = Path(sysconfig.get_path("include"))
    if not (include / "Python.h").exists():
        raise CompileFailure(f"no headers of Python ({include / 'Python.h'} not found)")
    shared = ["-shared"]
    if sys.platform == "darwin":
        shared = ["-bundle", "-undefined", "dynamic_lookup", "-arch", platform.machine()]
    limited = ["-DCYTHON_LIMITED_API=1", "-DPy_LIMITED_API=0x030B0000"] if STABLE else []
    options = [*FLAGS.split(), *shared, *limited, f"-I{include}"]
    library = folder / "_compiled.so"
    (folder / "_compiled.pyx").write_text(text, encoding="utf-8")
    run("Cython", [sys.executable, "-m", "cython", "-3", "_compiled.pyx"], folder)
    command = [*words, *options, "_compiled.c", "-o", library.name, "-lm"]
    run("the C compiler", command, folder)
    probe = [sys.executable, "-c", PROBE, str(library), str(known)]
    try:
        run("the test", probe, folder)
    except CompileFailure:
        raise CompileFailure(
            f"compiled, the core does not have the results of its source; the C compiler "
            f"({shlex.join(words)}) needs other options"
        ) from None
    return library


def run(tool: str, command: list[str], folder: Path) -> None:
    """Run a tool; its output is shown only if it fails."""
    shown = f"{shlex.join(command[:3])} ..."
    try:
        process = _run(command, folder)
    except OSError as error:
        raise CompileFailure(f"{tool} failed ({shown}: {error.strerror})") from None
    if process.returncode:
        sys.stderr.write(process.stdout + process.stderr)
        raise CompileFailure(f"{tool} failed ({shown})")


def _run(command: list[str], folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command, and keep what it prints."""
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, errors="replace", check=False
    )
