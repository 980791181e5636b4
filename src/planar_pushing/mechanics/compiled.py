"""The decorators of the compiled core, and where its cache lives.

A formula is a function of numbers. `compiled` makes it a part of compiled code, which Python enters by a
`kernel`; with ``NUMBA_DISABLE_JIT=1`` all stay the Python functions that they are. `generic` chooses a body
by the type of the first argument, in compiled code as in Python: what a scene does not list is not compiled
into its functions.
"""

from __future__ import annotations

import functools
import hashlib
import logging
import os
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

import llvmlite.binding
import numba
from numba.core.caching import UserProvidedCacheLocator
from numba.extending import overload

Function = TypeVar("Function", bound=Callable[..., Any])

#: Packages whose sources are compiled. Numba's cache sees changes in a function's own file only; the
#: digest of all these files keeps stale callees out.
SOURCES = ("mechanics", "simulation")
#: How every function is compiled: to run beside others, to divide as numpy does, exactly, and to count no
#: references to arrays, which takes longer than many a formula.
OPTIONS = {"nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True, "_nrt": False}
LOG = logging.getLogger("planar_pushing")
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
    """Folder of the cache: beside the sources where they can be written, else the user's own."""
    users = Path(os.environ.get("XDG_CACHE_HOME") or Path("~/.cache").expanduser())
    name = f"compiled-{_digest()}"
    for base in (PACKAGE / "__pycache__", users / "planar-pushing", Path(tempfile.gettempdir())):
        try:
            (base / name).mkdir(parents=True, exist_ok=True)
        except OSError:
            continue
        if os.access(base / name, os.W_OK):
            return base / name
    raise OSError("no folder for compiled code can be written; set XDG_CACHE_HOME to one that can")


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


def compiled(function: Function, **options: Any) -> Function:
    """Compile a function of numbers as a part of the kernels that call it, however deep.

    There is no fast mathematics: every run gives the same results. It may read and write arrays and hand
    them on, but makes none. Called from Python it runs as the Python function that it is: what is called
    often is a `kernel`.
    """
    _PARTS[function] = OPTIONS | options
    overload(function, jit_options=_PARTS[function], strict=False)(lambda *args: function)
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
    before = numba.config.CACHE_LOCATOR_CLASSES
    numba.config.CACHE_LOCATOR_CLASSES = f"{__name__}.{Locator.__name__}"
    try:
        made = numba.njit(cache=True, **_PARTS[function])(function)
    finally:
        numba.config.CACHE_LOCATOR_CLASSES = before
    return made  # type: ignore[no-any-return]


def inlined(function: Function) -> Function:
    """Compile a function as a part of the functions that call it, and not by itself.

    The compiler optimises a function together with all that it calls, so each layer of functions above a
    large one costs its time again; a layer that is inlined costs nothing.
    """
    return numba.njit(inline="always", **OPTIONS)(function)  # type: ignore[no-any-return]


@contextmanager
def announced(kernel: Any) -> Iterator[None]:
    """Say on the log when a call has had to compile what it calls, which takes seconds."""
    before, start = _compilations(kernel), time.perf_counter()
    yield
    if _compilations(kernel) > before:
        seconds = time.perf_counter() - start
        LOG.info(
            "compiled %s in %.0f s; later runs read it from %s", kernel.__name__, seconds, CACHE
        )


def _compilations(kernel: Any) -> int:
    return sum(kernel.stats.cache_misses.values()) if hasattr(kernel, "stats") else 0


def generic(choose: Callable[[Any], Callable[..., Any]], **options: Any) -> Callable[..., Any]:
    """Make a function whose body `choose` picks by the kind of its first argument.

    The kind of a named tuple is its class, that of a plain tuple the tuple of its entries' kinds.
    """

    @functools.wraps(choose)
    def function(first: Any, *rest: Any) -> Any:
        return choose(_kind(first))(first, *rest)

    def typed(first: Any, *rest: Any) -> Any:
        # Not a call of the body: a layer between would be optimised with all that the body calls.
        body = choose(_kind_of_type(first))
        return getattr(body, "py_func", body)

    overload(function, jit_options=OPTIONS | options, strict=False)(typed)
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
