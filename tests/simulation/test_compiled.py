"""Bodies by type, and the folder of the cache."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple

import pytest
from numba.core.caching import CompileResultCacheImpl, FunctionCache

from planar_pushing.simulation.legacy import compiled as core
from planar_pushing.simulation.legacy.compiled import compiled, generic, inlined, kernel


class Metres(NamedTuple):
    """A length."""

    size: float


class Feet(NamedTuple):
    """A length of another kind; fields of one type."""

    size: float


@compiled
def _metres(length, factor):
    return length.size * factor


@compiled
def _feet(length, factor):
    return 0.3048 * length.size * factor


@compiled
def _both(lengths, factor):
    return in_metres(lengths[0], factor) + in_metres(lengths[1:], factor)


@compiled
def _last(lengths, factor):
    return in_metres(lengths[0], factor)


@generic
def in_metres(kind):
    """Length in metres, the sum of a tuple's."""
    if isinstance(kind, tuple):
        return _last if len(kind) == 1 else _both
    return {Metres: _metres, Feet: _feet}[kind]


@kernel
@compiled
def measured(lengths, factor):
    return in_metres(lengths, factor)


def test_the_type_of_the_first_argument_chooses_the_body():
    for call in (measured, in_metres):
        assert call(Metres(2.0), 3.0) == 6.0
        assert call(Feet(2.0), 3.0) == pytest.approx(1.8288, rel=1e-15, abs=0)
        assert call((Feet(1.0), Metres(1.0)), 1.0) == pytest.approx(1.3048, rel=1e-15, abs=0)
        assert call((Feet(1.0),), 1.0) == 0.3048


def test_a_kind_without_a_body_is_refused():
    with pytest.raises(KeyError):
        in_metres(1.0, 1.0)


def test_the_digest_sees_every_compiled_source(tmp_path, monkeypatch):
    for name in ("simulation/a.py", "simulation/steps/b.py", "figures/c.py"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("x = 1\n")
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    digests = [core._digest()]
    for name in ("figures/c.py", "simulation/a.py", "simulation/steps/b.py"):
        (tmp_path / name).write_text("x = 2\n")
        digests.append(core._digest())
    assert digests[0] == digests[1]
    assert len(set(digests)) == 3


def test_the_cache_is_beside_the_sources_or_in_the_users_folder(tmp_path, monkeypatch):
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "own"))
    assert Path(core._folder()).parent == tmp_path / "__pycache__"
    shutil.rmtree(tmp_path / "__pycache__")
    (tmp_path / "__pycache__").write_text("no folder\n")
    assert Path(core._folder()).parent == tmp_path / "own/planar-pushing"
    (tmp_path / "own/planar-pushing").rename(tmp_path / "other")
    (tmp_path / "own/planar-pushing").write_text("no folder\n")
    monkeypatch.setattr(core.tempfile, "gettempdir", lambda: str(tmp_path / "__pycache__"))
    with pytest.raises(OSError, match="set XDG_CACHE_HOME"):
        core._folder()


@pytest.mark.parametrize("kind", ["group", "others", "owner", "link"])
def test_a_cache_that_somebody_else_can_write_is_not_taken(tmp_path, monkeypatch, kind):
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "own"))
    folder = core._folder()
    assert folder.stat().st_mode & 0o022 == 0
    if kind == "link":
        folder.rename(tmp_path / "elsewhere")
        folder.symlink_to(tmp_path / "elsewhere")
    elif kind == "owner":
        lstat = Path.lstat

        def owned(path):
            status = lstat(path)
            other = os.getuid() + (path == folder)
            return SimpleNamespace(st_mode=status.st_mode, st_uid=other)

        monkeypatch.setattr(Path, "lstat", owned)
    else:
        folder.chmod({"group": 0o775, "others": 0o757}[kind])
    assert core._folder().parent == tmp_path / "own/planar-pushing"


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    """The folder of the cache where only the temporary folder can be written."""
    (tmp_path / "file").touch()
    monkeypatch.setattr(core, "PACKAGE", tmp_path / "file")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setattr(core.tempfile, "gettempdir", lambda: str(tmp_path))
    return tmp_path / f"planar-pushing-{os.getuid()}"


def test_a_cache_in_the_temporary_folder_is_closed_to_others(temporary):
    assert core._folder().parent == temporary
    assert temporary.stat().st_mode & 0o777 == 0o700
    assert core._folder().parent == temporary


def test_a_temporary_cache_that_others_may_write_is_refused(temporary):
    temporary.mkdir()
    temporary.chmod(0o770)
    with pytest.raises(OSError, match="set XDG_CACHE_HOME"):
        core._folder()


def test_a_link_to_a_temporary_cache_is_refused(temporary):
    (temporary.parent / "elsewhere").mkdir(mode=0o700)
    temporary.symlink_to("elsewhere")
    with pytest.raises(OSError, match="set XDG_CACHE_HOME"):
        core._folder()


def test_a_temporary_cache_of_another_user_is_refused(temporary, monkeypatch):
    temporary.mkdir(mode=0o700)
    status = temporary.lstat()
    other = os.stat_result((*status[:4], status.st_uid + 1, *status[5:10]))
    monkeypatch.setattr(Path, "lstat", lambda _: other)
    with pytest.raises(OSError, match="set XDG_CACHE_HOME"):
        core._folder()


def test_other_packages_keep_their_cache_folder():
    for caching in (FunctionCache, CompileResultCacheImpl):
        assert core.Locator not in getattr(caching, "_locator_classes", ())
    found = core.Cache(test_other_packages_keep_their_cache_folder)
    assert Path(found.cache_path).is_relative_to(core.CACHE)


def test_a_compiled_function_is_kept_by_its_place_in_the_package(tmp_path, monkeypatch):
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    here = core.Locator(test_other_packages_keep_their_cache_folder, str(tmp_path / "a/b/c.py"))
    assert Path(here.get_cache_path()) == core.CACHE / "a/b"
    other = core.Locator(test_other_packages_keep_their_cache_folder, __file__)
    assert Path(other.get_cache_path()).parent == core.CACHE


@inlined
def tripled(x):
    return 3.0 * x


@kernel
@compiled
def raised(x):
    return tripled(x) + 1.0


def test_an_inlined_function_is_a_part_of_its_caller():
    assert raised(2.0) == tripled(2.0) + 1.0 == 7.0
