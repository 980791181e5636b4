"""The decorators of the compiled core, and where its cache lives.

A formula is a function of numbers. `compiled` makes it a part of compiled code, which Python enters by a
`kernel`; with ``NUMBA_DISABLE_JIT=1`` all stay the Python functions that they are. `generic` chooses a body
by the type of the first argument, in compiled code as in Python: what a scene does not list is not compiled
into its functions.
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

#: Packages whose sources are compiled. Numba's cache sees changes in a function's own file only; the
#: digest of all these files keeps stale callees out.
SOURCES = ("mechanics", "simulation")
#: How every function is compiled: to run beside others, to divide as numpy does, exactly, and to count no
#: references to arrays, which takes longer than many a formula.
OPTIONS = {"nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True, "_nrt": False}
#: And a function that is a part of kernels alone: Python has no way into it.
PART = {"no_cpython_wrapper": True}
LOG = logging.getLogger("planar_pushing")
#: Kernels that take long to compile: what a user calls, and seconds of one core of a virtual machine, on
#: average over the kinds of sliders; the longest take twice as long.
SLOW = {
    "planar_pushing.mechanics.solve._modes": ("solve", 25),
    "planar_pushing.mechanics.cones._motion_cones": ("motion_cone", 10),
    "planar_pushing.simulation.events.driver.advance": ("simulate", 25),
    "planar_pushing.simulation.steps.driver.advance": ("simulate by time-stepping", 10),
}
#: How each function that is a part of kernels is compiled.
_PARTS: dict[Any, dict[str, Any]] = {}
PACKAGE = Path(__file__).parents[1]


def _digest() -> str:
    """Digest of the compiled sources, of the compiler and of the processor."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.binding.get_host_cpu_name()}".encode())
    for path in sorted(path for name in SOURCES for path in (PACKAGE / name).rglob("*.py")):
        digest.update(f"{path.relative_to(PACKAGE)}\0".encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def _folder() -> Path:
    """Folder of the cache: beside the sources where they can be written, else the user's own.

    Whoever writes there runs code as the user, so a folder in the temporary one is nobody else's.
    """
    users = Path(os.environ.get("XDG_CACHE_HOME") or Path("~/.cache").expanduser())
    name, own = (
        f"compiled-{_digest()}",
        Path(tempfile.gettempdir()) / f"planar-pushing-{os.getuid()}",
    )
    for base in (PACKAGE / "__pycache__", users / "planar-pushing", own):
        with suppress(OSError):
            base.mkdir(mode=0o700 if base == own else 0o777, parents=True, exist_ok=True)
            if base == own and not _is_private(own):
                continue
            (base / name).mkdir(exist_ok=True)
            if os.access(base / name, os.W_OK):
                return base / name
    raise OSError(
        "no folder of your own for compiled code can be written; set XDG_CACHE_HOME to one that can"
    )


def _is_private(folder: Path) -> bool:
    """Whether a folder, and no link to one, is the user's and closed to everybody else."""
    status = folder.lstat()
    return status.st_uid == os.getuid() and status.st_mode & 0o170077 == stat.S_IFDIR


CACHE = _folder()


class Locator(UserProvidedCacheLocator):  # type: ignore[misc]
    """Where numba keeps a function of ours: by its place in the package, wherever the package lies."""

    def __init__(self, function: Any, file: str) -> None:
        self._py_file = file
        self._lineno = function.__code__.co_firstlineno
        folder = Path(file).parent
        own = folder.relative_to(PACKAGE) if folder.is_relative_to(PACKAGE) else None
        self._cache_path = str(CACHE / (own or self.get_suitable_cache_subpath(file)))

    @classmethod
    def from_function(cls, function: Any, file: str) -> Locator:
        """Make the locator of a function; others of numba's locators are not asked."""
        return cls(function, file)


class Files(CompileResultCacheImpl):  # type: ignore[misc]
    """The files of a function's cache, in the folder of its locator."""

    _locator_classes = (Locator,)


class Cache(FunctionCache):  # type: ignore[misc]
    """A function's cache, which several processes write one at a time."""

    _impl_class = Files

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Load machine code; a file that is damaged can fail in any way."""
        try:
            return super().load_overload(sig, target_context)
        except Exception as error:
            raise OSError(f"{CACHE}: damaged compiled code; remove this folder") from error

    def save_overload(self, sig: Any, data: Any) -> None:
        """Save machine code: numba numbers the files of a function by its index."""
        self._impl.locator.ensure_cache_path()
        with Path(self.cache_path, "lock").open("w") as lock:
            with suppress(OSError):  # a cluster's file system may know no locks
                fcntl.flock(lock, fcntl.LOCK_EX)
            super().save_overload(sig, data)


class UnderWay(event.Listener):  # type: ignore[misc]
    """The functions that are being compiled; each of those that take long is announced.

    Numba makes machine code of every function by itself, and of all that it calls. Of a part of a kernel,
    which is a third of the time, nobody needs it: the kernel links the part's intermediate code.
    """

    def __init__(self) -> None:
        self.parts: list[bool] = []

    def on_start(self, event: Any) -> None:
        """Announce a kernel that takes long to compile, before numba, whose cache holds no code, starts."""
        dispatcher = event.data["dispatcher"]
        function = dispatcher.py_func
        what, seconds = SLOW.get(f"{function.__module__}.{function.__qualname__}", ("", 0))
        if what:
            message = "compiling %s for this kind of slider, once; this takes about %d s"
            LOG.warning(message, what, seconds)
        self.parts.append(dispatcher.targetoptions.get("no_cpython_wrapper", False))

    def on_end(self, event: Any) -> None:
        """Go back to the function that calls the one that is done."""
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
    """Make machine code of a library's functions, unless they are a part of others."""
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
    """The way from Python into a function, which a part of others has not."""
    if not UNDER_WAY.is_part:
        return make(context, library, description, environment)
    own = description.lookup_module(), description.qualname, "", 1, environment, (library,)
    return _dynfunc.make_function(*own)


CPUCodeLibrary._finalize_final_module = _finalize
CPUContext.get_executable = _executable


def compiled(function: Function, **options: Any) -> Function:
    """Compile a function of numbers as a part of the kernels that call it, however deep.

    There is no fast mathematics: every run gives the same results. It may read and write arrays and hand
    them on, but makes none. Called from Python it runs as the Python function that it is: what is called
    often is a `kernel`.
    """
    _PARTS[function] = OPTIONS | options
    overload(function, jit_options=_PARTS[function] | PART, strict=False)(lambda *args: function)
    return function


def owning(function: Function) -> Function:
    """Compile a function that makes arrays, or calls one that is `owning` and gives arrays back.

    It counts references, so what it is given back has to be counted: it calls no `compiled` function that
    gives arrays back.
    """
    return compiled(function, _nrt=True)


def summing(function: Function) -> Function:
    """Compile a sum over an array as a part of its callers.

    It adds several terms at once, and multiplies and adds in one step, as the processor can: its last digit
    depends on the processor, but not on the run.
    """
    return compiled(function, forceinline=True, fastmath={"reassoc", "contract"})


def fused(function: Function) -> Function:
    """Compile a polynomial as a part of its callers, each product and sum in one step as in `summing`."""
    return compiled(function, fastmath={"contract"})


def kernel(function: Function) -> Function:
    """Let Python call a `compiled` or `owning` function as machine code, which is kept in the cache.

    Only kernels are kept: each holds all that it calls.
    """
    made = numba.njit(**_PARTS[function])(function)
    if made is not function:
        made._cache = Cache(function)
    return made  # type: ignore[no-any-return]


def inlined(function: Function) -> Function:
    """Compile a function as a part of the functions that call it, and not by itself.

    The compiler optimises a function together with all that it calls, so each layer of functions above a
    large one costs its time again; a layer that is inlined costs nothing.
    """
    return numba.njit(inline="always", **OPTIONS)(function)  # type: ignore[no-any-return]


def generic(choose: Callable[[Any], Callable[..., Any]], **options: Any) -> Callable[..., Any]:
    """Make a function whose body `choose` picks by the kind of its first argument.

    The kind of a named tuple is its class, that of a plain tuple the tuple of its entries' kinds.
    """

    @functools.wraps(choose)
    def function(first: Any, *rest: Any) -> Any:
        return choose(_kind(first))(first, *rest)

    def typed(first: Any, *rest: Any) -> Any:
        # Not a call of the body: a layer between would be optimized with all that the body calls.
        body = choose(_kind_of_type(first))
        return getattr(body, "py_func", body)

    overload(function, jit_options=OPTIONS | options | PART, strict=False)(typed)
    return function


def generic_owning(choose: Callable[[Any], Callable[..., Any]]) -> Callable[..., Any]:
    """Make a function as `generic` does, whose bodies are `owning`."""
    return generic(choose, _nrt=True)


def by_kind(members: dict[type, Any], name: str) -> Callable[..., Any]:
    """The function of a name in the module that belongs to the kind of the first argument."""
    return generic(lambda kind: getattr(members[kind], name))


def _kind(value: Any) -> Any:
    return tuple(map(_kind, value)) if type(value) is tuple else type(value)


def _kind_of_type(kind: Any) -> Any:
    if hasattr(kind, "instance_class"):
        return kind.instance_class
    return tuple(map(_kind_of_type, kind.types))
