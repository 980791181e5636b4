"""The decorators of compiled functions, and the location of their cache.

A formula is a function of numbers. `compiled` makes it a part of compiled code, which Python enters through
a `kernel`; with ``NUMBA_DISABLE_JIT=1`` all remain plain Python functions. `generic` chooses a body by the
type of the first argument, in compiled code as in Python: effects that a scene does not list are not
compiled into its functions.
"""

from __future__ import annotations

import fcntl
import functools
import hashlib
import logging
import os
import stat
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

import llvmlite.binding
import numba
from numba import _dynfunc
from numba.core import event
from numba.core.caching import CompileResultCacheImpl, FunctionCache, UserProvidedCacheLocator
from numba.core.codegen import CPUCodeLibrary
from numba.core.cpu import CPUContext
from numba.extending import overload

Function = TypeVar("Function", bound=Callable[..., Any])

#: Packages whose sources are compiled. Numba's cache detects changes in a function's own file only; the
#: digest of all these files excludes stale callees.
SOURCES = ("simulation",)
#: Options of every function: it releases the GIL, divides as numpy does, and counts no references to
#: arrays, which would take longer than many a formula.
OPTIONS = {"nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True, "_nrt": False}
#: Further option of a function that is only a part of kernels: it has no entry point from Python.
PART = {"no_cpython_wrapper": True}
LOG = logging.getLogger("planar_pushing")
#: Kernels that take long to compile: the user's call, and seconds on one core of a virtual machine,
#: averaged over the kinds of sliders; the slowest take twice as long.
SLOW = {
    "planar_pushing.simulation.events.driver.advance": ("simulate", 25),
    "planar_pushing.simulation.steps.driver.advance": ("simulate by time-stepping", 10),
}
#: Options of each function that is a part of kernels.
_PARTS: dict[Any, dict[str, Any]] = {}
PACKAGE = Path(__file__).parents[2]


def _digest() -> str:
    """Digest of the compiled sources, the compiler and the processor."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.binding.get_host_cpu_name()}".encode())
    for path in sorted(path for name in SOURCES for path in (PACKAGE / name).rglob("*.py")):
        digest.update(f"{path.relative_to(PACKAGE)}\0".encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def _folder() -> Path:
    """Folder of the cache: beside the sources if writable, otherwise in the user's own cache.

    Whoever can write there runs code as the user, so the folder must belong to the user and be closed to
    the writing of others, and a folder among temporary files must be private.
    """
    users = Path(os.environ.get("XDG_CACHE_HOME") or Path("~/.cache").expanduser())
    name, own = (
        f"compiled-{_digest()}",
        Path(tempfile.gettempdir()) / f"planar-pushing-{os.getuid()}",
    )
    for base in (PACKAGE / "__pycache__", users / "planar-pushing", own):
        with suppress(OSError):
            base.mkdir(mode=0o700 if base == own else 0o777, parents=True, exist_ok=True)
            if base == own and not _is_closed(own, 0o077):
                continue
            (base / name).mkdir(mode=0o700, exist_ok=True)
            if _is_closed(base / name, 0o022) and os.access(base / name, os.W_OK):
                return base / name
    raise OSError(
        "no private folder for compiled code is writable; set XDG_CACHE_HOME to a folder that is"
    )


def _is_closed(folder: Path, rights: int) -> bool:
    """Whether a path is a folder, not a link, of the user, to which others do not have these rights."""
    status = folder.lstat()
    return status.st_uid == os.getuid() and status.st_mode & (0o170000 | rights) == stat.S_IFDIR


CACHE = _folder()


class Locator(UserProvidedCacheLocator):  # type: ignore[misc]
    """Cache location of a function, by its path in the package, wherever the package is installed."""

    def __init__(self, function: Any, file: str) -> None:
        self._py_file = file
        self._lineno = function.__code__.co_firstlineno
        folder = Path(file).parent
        own = folder.relative_to(PACKAGE) if folder.is_relative_to(PACKAGE) else None
        self._cache_path = str(CACHE / (own or self.get_suitable_cache_subpath(file)))

    @classmethod
    def from_function(cls, function: Any, file: str) -> Locator:
        """Make the locator of a function; numba's other locators are not used."""
        return cls(function, file)


class Files(CompileResultCacheImpl):  # type: ignore[misc]
    """The files of a function's cache, in the folder of its locator."""

    _locator_classes = (Locator,)


class Cache(FunctionCache):  # type: ignore[misc]
    """A function's cache, which processes write one at a time."""

    _impl_class = Files

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Load machine code; a damaged file can fail in any way."""
        try:
            return super().load_overload(sig, target_context)
        except Exception as error:
            raise OSError(f"{CACHE}: damaged compiled code; remove this folder") from error

    def save_overload(self, sig: Any, data: Any) -> None:
        """Save machine code, under a lock because numba numbers the files of a function in an index."""
        self._impl.locator.ensure_cache_path()
        with Path(self.cache_path, "lock").open("w") as lock:
            with suppress(OSError):  # a cluster's file system may not support locks
                fcntl.flock(lock, fcntl.LOCK_EX)
            super().save_overload(sig, data)


class UnderWay(event.Listener):  # type: ignore[misc]
    """The functions that are being compiled; slow ones are announced.

    Numba makes machine code for every function separately, including all that it calls. For a part of a
    kernel this is skipped, which saves a third of the time: the kernel links the part's intermediate code.
    """

    def __init__(self) -> None:
        self.parts: list[bool] = []

    def on_start(self, event: Any) -> None:
        """Announce a kernel that takes long to compile and is not in the cache."""
        dispatcher = event.data["dispatcher"]
        function = dispatcher.py_func
        what, seconds = SLOW.get(f"{function.__module__}.{function.__qualname__}", ("", 0))
        if what:
            message = "compiling %s for this kind of slider, once; this takes about %d s"
            LOG.warning(message, what, seconds)
        self.parts.append(dispatcher.targetoptions.get("no_cpython_wrapper", False))

    def on_end(self, event: Any) -> None:
        """Return to the caller of the function that is done."""
        self.parts.pop()

    @property
    def is_part(self) -> bool:
        """Whether the innermost function is a part of a kernel."""
        return bool(self.parts) and self.parts[-1]


UNDER_WAY = UnderWay()
event.register("numba:compile", UNDER_WAY)


def _finalize(
    library: Any, make: Callable[[Any], None] = CPUCodeLibrary._finalize_final_module
) -> None:
    """Make machine code for the functions of a library, unless they are parts of others."""
    if UNDER_WAY.is_part:
        library._finalize_dynamic_globals()
        library._verify_declare_only_symbols()
        library._finalized = True
    else:
        make(library)


def _executable(
    context: Any, library: Any, description: Any, environment: Any,
    make: Callable[..., Any] = CPUContext.get_executable,
) -> Any:  # fmt: skip
    """The entry point from Python to a function; a part of others gets a placeholder."""
    if not UNDER_WAY.is_part:
        return make(context, library, description, environment)
    own = description.lookup_module(), description.qualname, "", 1, environment, (library,)
    return _dynfunc.make_function(*own)


CPUCodeLibrary._finalize_final_module = _finalize
CPUContext.get_executable = _executable


def compiled(function: Function, **options: Any) -> Function:
    """Compile a function of numbers as a part of the kernels that call it, directly or indirectly.

    Fast math is off, so multiplication and addition are never fused and sums keep their order: results do
    not depend on the processor. The function can read, write and pass on arrays, but not create them.
    Called from Python it runs as plain Python; a function that Python calls often should be a `kernel`.
    """
    _PARTS[function] = OPTIONS | options
    overload(function, jit_options=_PARTS[function] | PART, strict=False)(lambda *args: function)
    return function


def owning(function: Function) -> Function:
    """Compile a function that creates arrays, or calls an `owning` function that returns arrays.

    It counts references, so arrays returned to it must be counted too: it must not call a `compiled`
    function that returns arrays.
    """
    return compiled(function, _nrt=True)


def kernel(function: Function) -> Function:
    """Compile a `compiled` or `owning` function to machine code that Python can call, and cache it.

    Only kernels are cached: each contains everything that it calls.
    """
    made = numba.njit(**_PARTS[function])(function)
    if made is not function:
        made._cache = Cache(function)
    return made  # type: ignore[no-any-return]


def inlined(function: Function) -> Function:
    """Compile a function only as a part of its callers.

    The compiler optimizes a function together with all that it calls, so each layer of functions above a
    large one costs the same time again; an inlined layer costs nothing.
    """
    return numba.njit(inline="always", **OPTIONS)(function)  # type: ignore[no-any-return]


def generic(choose: Callable[[Any], Callable[..., Any]], **options: Any) -> Callable[..., Any]:
    """Make a function whose body `choose` picks by the kind of the first argument.

    The kind of a named tuple is its class; that of a plain tuple is the tuple of the kinds of its entries.
    """

    @functools.wraps(choose)
    def function(first: Any, *rest: Any) -> Any:
        return choose(_kind(first))(first, *rest)

    def typed(first: Any, *rest: Any) -> Any:
        # The body itself, not a call of it: an extra layer would be optimized with all that the body calls.
        body = choose(_kind_of_type(first))
        return getattr(body, "py_func", body)

    overload(function, jit_options=OPTIONS | options | PART, strict=False)(typed)
    return function


def generic_owning(choose: Callable[[Any], Callable[..., Any]]) -> Callable[..., Any]:
    """Make a function as `generic` does, with `owning` bodies."""
    return generic(choose, _nrt=True)


def by_kind(members: dict[type, Any], name: str) -> Callable[..., Any]:
    """The function with a given name in the module that belongs to the kind of the first argument."""
    return generic(lambda kind: getattr(members[kind], name))


def _kind(value: Any) -> Any:
    return tuple(map(_kind, value)) if type(value) is tuple else type(value)


def _kind_of_type(kind: Any) -> Any:
    if hasattr(kind, "instance_class"):
        return kind.instance_class
    return tuple(map(_kind_of_type, kind.types))
