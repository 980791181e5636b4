"""Build the core at installation, as a hook of hatchling, or in a clone: ``python -m joiner.hook``.

Without a compiler, or without what it needs, there is no library, and the package runs the core as plain
Python. With ``PLANAR_PUSHING_COMPILED=1`` in the environment that is an error, for those who make packages.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import runpy
import shlex
import shutil
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import platform_tags

ROOT = Path(__file__).resolve().parents[1]
# Hatchling loads this file by its path.
sys.path.insert(0, str(ROOT))
from joiner import RefusedSource, compiler, join, module  # noqa: E402

CORE = ROOT / "src" / "planar_pushing" / "core"
TARGET = "_compiled" + (".abi3.so" if compiler.STABLE else sysconfig.get_config_var("EXT_SUFFIX"))
#: The package has the digest of the sources, and the known results of the compiled module.
KNOWN = CORE / "__init__.py"
REQUIRED = "PLANAR_PUSHING_COMPILED"


def build(core: Path = CORE, folder: Path | None = None) -> Path | None:
    """Compile the core unless it is up to date.

    Parameters
    ----------
    core : Path
        The folder of the modules.
    folder : Path, optional
        Where a new library is written; without it beside the modules, in the place of an older one.

    Returns
    -------
    Path or None
        The library; None without the tools, after a line that says so.

    Raises
    ------
    RefusedSource
        A module is not in the language of the core.
    CompileFailure
        The tools are missing although ``PLANAR_PUSHING_COMPILED=1`` requires them.
    """
    # The digest is taken first: a module that is edited meanwhile then makes the library out of date.
    digest = runpy.run_path(str(KNOWN))["digest"](sorted(core.rglob("[!_]*.py")))
    text, library = module.text_of(join(core)), core / TARGET
    try:
        marks = [f"sources {digest}", f"recipe {recipe(text)}"]
        if library.exists() and all(mark.encode() in library.read_bytes() for mark in marks):
            with contextlib.suppress(OSError):  # a folder that cannot be written
                library.touch()
            return library
        target = (folder or core) / TARGET
        with tempfile.TemporaryDirectory() as name:
            marked = text + module.MARKS.format(*marks)
            new = compiler.compile_library(marked, Path(name), KNOWN)
            replace(target, new)
    except compiler.CompileFailure as failure:
        if folder is None:
            with contextlib.suppress(OSError):  # its digest tells that it is out of date
                library.unlink(missing_ok=True)
        if os.environ.get(REQUIRED, "") not in ("", "0"):
            raise compiler.CompileFailure(
                f"{failure}; {REQUIRED}={os.environ[REQUIRED]} requires the compiled core"
            ) from None
        slower = "the core runs as plain Python, about 100 times slower"
        print(f"planar-pushing: {failure}; {slower}", file=sys.stderr)
        return None
    return target


def recipe(text: str) -> str:
    """A digest of all that makes the library: text, Cython, the compiler, its options, and the platform."""
    words = compiler.compiler()
    tools = [compiler.cython_version(), shlex.join(words), compiler.compiler_version(*words)]
    ingredients = [text, *tools, compiler.FLAGS, sysconfig.get_platform()]
    return hashlib.sha256("\0".join(ingredients).encode()).hexdigest()


def replace(target: Path, new: Path) -> None:
    """Replace a library by a new one, completely or not at all."""
    copy = target.with_name(f".{TARGET}.{os.getpid()}")
    try:
        _forget_copies(target)
        shutil.copy(new, copy)
        copy.replace(target)
    except OSError as error:
        reason = error.strerror or "no reason given"
        raise compiler.CompileFailure(f"{target.parent} cannot be written: {reason}") from None
    finally:
        with contextlib.suppress(OSError):
            copy.unlink(missing_ok=True)


def _forget_copies(target: Path) -> None:
    """Remove the copies that killed builds have left; that of a build that still runs stays."""
    for copy in target.parent.glob(f".{TARGET}.*"):
        number = copy.name.rpartition(".")[2]
        if number.isdecimal() and not _is_running(int(number)):
            with contextlib.suppress(OSError):
                copy.unlink()


def _is_running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):  # of another user, or no number of a process
        return True
    return True


def build_or_exit(folder: Path | None = None) -> Path | None:
    """Build the core of this project, or end with one message."""
    try:
        return build(CORE, folder)
    except RefusedSource as refused:
        sys.exit(
            f"{refused}\nplanar-pushing: the core must be written in its language; see CONTRIBUTING.md"
        )
    except compiler.CompileFailure as failure:
        sys.exit(f"planar-pushing: {failure}")


class CoreHook(BuildHookInterface):  # type: ignore[type-arg]
    """Compile the core into the wheel, which then is for this platform and for every Python from 3.11."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build, and tell hatchling what the wheel contains.

        Only an editable installation writes to the folder of the sources.
        """
        self.folder = tempfile.TemporaryDirectory()
        target = build_or_exit(None if version == "editable" else Path(self.folder.name))
        if target is None:
            return
        build_data["pure_python"] = False
        if compiler.STABLE:
            kind = sysconfig.get_platform() if sys.platform == "linux" else next(platform_tags())
            build_data["tag"] = f"cp311-abi3-{kind.replace('-', '_').replace('.', '_')}"
        else:
            build_data["infer_tag"] = True
        if version != "editable":
            build_data["force_include"][str(target)] = f"planar_pushing/core/{TARGET}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove the library that is in the wheel now."""
        self.folder.cleanup()


if __name__ == "__main__":
    build_or_exit()
