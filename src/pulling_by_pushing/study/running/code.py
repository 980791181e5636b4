"""Digests of the code that a workflow job runs; a change of the code makes the job's results outdated.

Snakemake tracks a script but not its imports. The digest of a job covers the modules that it names and all
modules of this project that they import, directly or not, with the data files beside them. Comments,
docstrings, layout, and imports that serve only the types do not count. The minor version of Python does.
"""

from __future__ import annotations

import ast
import hashlib
import json
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.replacing import replacing

PAPER = "pulling_by_pushing"
#: The packages whose modules count, and their folders.
ROOTS = {
    name: Path(find_spec(name).submodule_search_locations[0])  # type: ignore[union-attr, index]
    for name in (PAPER, "planar_pushing")
}
#: Package whose modules are imported together, by name.
CORE = "planar_pushing.core"
#: Endings of data files that count for all modules beside them.
DATA = (".yaml", ".mplstyle", ".json", ".csv")
#: Facts about files, kept from one run to the next for this version of Python, and their format.
CACHE, FORMAT = Path(".snakemake/code.json"), [2, *sys.version_info[:2]]

#: Digest of a file, names of the modules that it imports, and its time and size when it was read.
Facts = dict[str, Any]


@cache
def code_of(*modules: str) -> str:
    """Digest of modules of `pulling_by_pushing`, such as "study.build", and of all that they import."""
    reached = closure(f"{PAPER}.{name}" for name in modules)
    files = {_path(name) for name in reached}
    files |= {file for folder in {file.parent for file in files} for file in _data_files(folder)}
    code_hash = hashlib.sha256()
    for file in sorted(files):
        code_hash.update(f"{file.name}\0{_facts(file)['digest']}\0".encode())
    return code_hash.hexdigest()


def closure(modules: Iterable[str]) -> set[str]:
    """Full names of modules and of all modules of this project that they import, directly or not."""
    reached: set[str] = set()
    ahead = list(modules)
    while ahead:
        name = ahead.pop()
        if name not in reached:
            reached.add(name)
            ahead += _facts(_path(name))["imports"]
            ahead += _modules_of_core() if name == CORE else []
    return reached


def value_of_code(name: str, digest: str, compute: Callable[[], Any]) -> Any:
    """Value that depends on code alone, as JSON; it is computed anew if the digest of the code differs.

    Parameters
    ----------
    name : str
        Name under which the value is kept.
    digest : str
        Digest of the code, from `code_of`.
    compute : callable
        Function without arguments that returns the value.
    """
    entry = _stored_facts()["values"].get(name)
    if not isinstance(entry, list) or entry[:1] != [digest]:
        _stored_facts()["values"][name] = entry = [digest, compute()]
    return entry[1]


def keep_facts() -> None:
    """Store what was read for the next run; a folder that cannot be written costs only time."""
    content = json.dumps(_stored_facts())
    with suppress(OSError, PlanarPushingError):
        stored = CACHE.read_text(encoding="utf-8") if CACHE.is_file() else ""
        if content != stored and CACHE.parent.is_dir():
            with replacing(CACHE) as temporary:
                temporary.write_text(content, encoding="utf-8")


def forget_facts() -> None:
    """Forget what was read in this process; files are then examined again."""
    for function in (code_of, _stored_facts, _facts, _path, _modules_of_core, _data_files):
        function.cache_clear()


@cache
def _stored_facts() -> dict[str, Any]:
    """Stored facts by file, and values that depend on code; empty if the store cannot be read."""
    empty: dict[str, Any] = {"format": FORMAT, "files": {}, "values": {}}
    try:
        stored = json.loads(CACHE.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return empty
    is_current = isinstance(stored, dict) and stored.get("format") == FORMAT
    return stored if is_current and stored.keys() == empty.keys() else empty


@cache
def _facts(file: Path) -> Facts:
    """Facts about a file, read again only if its time or size has changed."""
    state, files = file.stat(), _stored_facts()["files"]
    stamp = [state.st_mtime_ns, state.st_size]
    facts: Facts | None = files.get(str(file))
    if facts is None or facts["stamp"] != stamp:
        facts = files[str(file)] = {"stamp": stamp} | _read(file)
    return facts


@cache
def _path(name: str) -> Path:
    """File of a module or a package."""
    root, *parts = name.split(".")
    path = ROOTS[root].joinpath(*parts)
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


@cache
def _modules_of_core() -> list[str]:
    """Names of all modules of the core; they are not kept, since a file can come or go."""
    folder = _path(CORE).parent
    paths = sorted(path.relative_to(folder) for path in folder.rglob("[!_]*.py"))
    return [".".join([CORE, *path.with_suffix("").parts]) for path in paths]


@cache
def _data_files(folder: Path) -> list[Path]:
    return [file for file in folder.iterdir() if file.suffix in DATA and file.is_file()]


def _read(file: Path) -> Facts:
    content = file.read_bytes()
    if file.suffix != ".py":
        return {"digest": hashlib.sha256(content).hexdigest(), "imports": []}
    tree = ast.parse(content)
    statements = list(_plain_statements(tree))  # all are read before the tree is used
    digest = hashlib.sha256(ast.dump(tree).encode()).hexdigest()
    return {"digest": digest, "imports": sorted(set(_imports(statements)))}


def _plain_statements(node: ast.AST) -> Iterator[ast.AST]:
    """Remove what `_is_for_readers` from the blocks of a tree, as they are read; yield the rest of them."""
    for name in ("body", "handlers", "orelse", "finalbody", "cases"):
        block = getattr(node, name, None)
        if isinstance(block, list):
            block[:] = [statement for statement in block if not _is_for_readers(statement)]
            for statement in block:
                yield statement
                yield from _plain_statements(statement)


def _is_for_readers(node: ast.AST) -> bool:
    """Whether a statement is a docstring, or a condition that holds only for a checker of types."""
    if isinstance(node, ast.If):
        return isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _imports(statements: Iterable[ast.AST]) -> Iterator[str]:
    """Modules of this project that statements import, at the top of a module or in a function."""
    for node in statements:
        if isinstance(node, ast.Import):
            yield from filter(_is_ours, (alias.name for alias in node.names))
        elif isinstance(node, ast.ImportFrom) and node.module and _is_ours(node.module):
            yield node.module
            yield from filter(_is_ours, (f"{node.module}.{alias.name}" for alias in node.names))


def _is_ours(name: str) -> bool:
    """Whether a name is that of a module or a package of this project."""
    return name.split(".")[0] in ROOTS and _path(name).is_file()
