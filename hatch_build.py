"""Build the core: join its modules into one Cython module, and compile that into a library for Python.

The installation runs this file as a hook of hatchling, and make runs it as a command. Without a compiler,
or without what it needs, there is no library, and the package runs the core as plain Python.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import platform
import runpy
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import platform_tags

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT))
from joiner import Joined, RefusedSource, join  # noqa: E402

CORE = ROOT / "src" / "planar_pushing" / "core"
#: Results do not depend on the processor: no fused multiply-add, and only instructions that all have.
FLAGS = (
    "-std=c11 -O3 -fno-trapping-math -fPIC -ffp-contract=off -fno-tree-vectorize -fno-math-errno -w"
)
if platform.machine() in ("x86_64", "AMD64"):
    # Records are copied number by number: a wider load has to wait for the narrow stores before it.
    FLAGS += " -mtune=core2"
#: Free-threaded Python has no stable binary interface for libraries.
STABLE = not sysconfig.get_config_var("Py_GIL_DISABLED")
TARGET = "_compiled" + (".abi3.so" if STABLE else sysconfig.get_config_var("EXT_SUFFIX"))

HEAD = """# cython: language_level=3, cdivision=True, binding=False, freethreading_compatible=True
# cython: emit_code_comments=False
from cpython.buffer cimport PyBUF_FULL_RO, PyBuffer_IsContiguous, PyBuffer_Release, PyObject_GetBuffer
from libc.math cimport {math}
from libc.string cimport memset

cdef inline long int_(double x) noexcept nogil: return <long> x
cdef inline long floor_(double x) noexcept nogil: return <long> floor(x)
cdef inline long ceil_(double x) noexcept nogil: return <long> ceil(x)
cdef inline double float_(double x) noexcept nogil: return x
cdef inline long floor_div_(long a, long b) noexcept nogil: return a // b - (a % b < 0)
cdef inline long min_int_(long a, long b) noexcept nogil: return b if b < a else a
cdef inline long max_int_(long a, long b) noexcept nogil: return b if b > a else a
cdef inline double min_float_(double a, double b) noexcept nogil: return b if b < a else a
cdef inline double max_float_(double a, double b) noexcept nogil: return b if b > a else a
"""
TAIL = '''
ctypedef void (*Kernel_)(double*, double*, long, long, double*, long) noexcept nogil

cdef int take_(numbers, Py_buffer* view, str name, long count, long width, bint written) except -1:
    """Hold the memory of an array that has the layout and the size that a kernel expects."""
    PyObject_GetBuffer(numbers, view, PyBUF_FULL_RO)
    if view.format != NULL and view.format[0] == b"d" and view.format[1] == 0:
        if PyBuffer_IsContiguous(view, b"C") and not (written and view.readonly):
            if count >= 0 and width >= 0 and (width == 0 or view.len // 8 // width >= count):
                return 0
    PyBuffer_Release(view)
    raise ValueError(f"{name}: contiguous numbers of type float64 expected, at least {count} times {width}")

cdef call_(Kernel_ kernel, data, rows, long count, long columns, results, long width):
    cdef Py_buffer data_view, rows_view, results_view
    take_(data, &data_view, "data", 0, 0, False)
    try:
        take_(rows, &rows_view, "rows", count, columns, False)
        try:
            take_(results, &results_view, "results", count, width, True)
            try:
                with nogil:
                    kernel(
                        <double*> data_view.buf, <double*> rows_view.buf, count, columns,
                        <double*> results_view.buf, width,
                    )
            finally:
                PyBuffer_Release(&results_view)
        finally:
            PyBuffer_Release(&rows_view)
    finally:
        PyBuffer_Release(&data_view)
'''
ENTRY = """
def {0}_(data, rows, long count, long columns, results, long width):
    call_({0}, data, rows, count, columns, results, width)
"""
# In C, so that they are text in the file.
MARKS = '''
cdef extern from *:
    """
    static const char digest_[] = "{0}";
    static const char recipe_[] = "{1}";
    """
    const char* digest_
    const char* recipe_

DIGEST = digest_[8:].decode("ascii")
RECIPE = recipe_[7:].decode("ascii")
'''


class MissingTool(Exception):
    """A tool for compiling is missing or fails; the message says which."""


def build(core: Path = CORE) -> Path | None:
    """Compile the core unless it is up to date; without the tools, say so and remove the old library."""
    # The digest is taken first: a module that is edited meanwhile then makes the library out of date.
    digest = runpy.run_path(str(CORE / "__init__.py"))["digest"](sorted(core.glob("[!_]*.py")))
    source, target = joined_source(join(core)), core / TARGET
    try:
        compile_source(source, digest, target)
    except MissingTool as missing:
        target.unlink(missing_ok=True)
        print(
            f"planar-pushing: {missing}; the core runs as plain Python, about 100 times slower",
            file=sys.stderr,
        )
        return None
    return target


def compile_source(source: str, digest: str, target: Path) -> None:
    """Write the library; it replaces an older one completely or not at all."""
    cython, compiler = cython_version(), compiler_command()
    recipe = f"{source} {cython} {FLAGS} {sysconfig.get_platform()}"
    marks = [f"sources {digest}", f"recipe {hashlib.sha256(recipe.encode()).hexdigest()}"]
    if target.exists() and all(mark.encode() in target.read_bytes() for mark in marks):
        target.touch()
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "_compiled.pyx").write_text(source + MARKS.format(*marks), encoding="utf-8")
        run("Cython", [sys.executable, "-m", "cython", "-3", "_compiled.pyx"], folder)
        run("the C compiler", [*compiler, "_compiled.c", "-o", "_compiled.so", "-lm"], folder)
        new = target.with_name(f".{TARGET}.{os.getpid()}")
        try:
            shutil.copy(folder / "_compiled.so", new)
            new.replace(target)
        finally:
            new.unlink(missing_ok=True)


def joined_source(joined: Joined) -> str:
    """The text of the module: the core, and a function for Python for each of its kernels."""
    entries = "".join(ENTRY.format(name) for name in joined.kernels)
    table = ", ".join(f'"{name}": {name}_' for name in joined.kernels)
    head = HEAD.format(math=", ".join(joined.math))
    return f"{head}{joined.source}{TAIL}{entries}\nKERNELS = {{{table}}}\n"


def cython_version() -> str:
    """The version of Cython."""
    if importlib.util.find_spec("Cython") is None:
        raise MissingTool("no Cython")
    return str(importlib.import_module("Cython").__version__)


def compiler_command() -> list[str]:
    """The C compiler of this Python, or the one of the variable CC, with its options."""
    compiler = os.environ.get("CC")
    commands = (
        [compiler] if compiler else [sysconfig.get_config_var("CC") or "cc", "cc", "gcc", "clang"]
    )
    usable = [command for command in commands if shutil.which((shlex.split(command) or [""])[0])]
    if not usable:
        raise MissingTool(f"no C compiler ({commands[0]} not found)")
    include = Path(sysconfig.get_path("include"))
    if not (include / "Python.h").exists():
        raise MissingTool(f"no headers of Python ({include / 'Python.h'} not found)")
    shared = ["-shared"]
    if sys.platform == "darwin":
        shared = ["-bundle", "-undefined", "dynamic_lookup", "-arch", platform.machine()]
    limited = ["-DCYTHON_LIMITED_API=1", "-DPy_LIMITED_API=0x030B0000"] if STABLE else []
    return [*shlex.split(usable[0]), *FLAGS.split(), *shared, *limited, f"-I{include}"]


def run(tool: str, command: list[str], folder: Path) -> None:
    """Run a tool; its output is shown only if it fails."""
    process = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, errors="replace", check=False
    )
    if process.returncode:
        sys.stderr.write(process.stdout + process.stderr)
        raise MissingTool(f"{tool} failed ({shlex.join(command[:3])} ...)")


class CoreHook(BuildHookInterface):  # type: ignore[type-arg]
    """Compile the core into the wheel, which then is for this platform and for every Python from 3.11."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build, and tell hatchling what the wheel contains."""
        target = build()
        if target is None:
            return
        build_data["pure_python"] = False
        if STABLE:
            kind = sysconfig.get_platform() if sys.platform == "linux" else next(platform_tags())
            build_data["tag"] = f"cp311-abi3-{kind.replace('-', '_').replace('.', '_')}"
        else:
            build_data["infer_tag"] = True
        if version == "standard":
            build_data["force_include"][str(target)] = f"planar_pushing/core/{TARGET}"


if __name__ == "__main__":
    try:
        build()
    except RefusedSource as refused:
        sys.exit(
            f"{refused}\nplanar-pushing: the core must be written in its language; see CONTRIBUTING.md"
        )
