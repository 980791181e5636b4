"""Bodies by type, the folder of the cache, and what is said of compilations."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import NamedTuple

import numba
import pytest

from mechanics.builders import needs_compiler
from planar_pushing.mechanics import compiled as core
from planar_pushing.mechanics.compiled import announced, compiled, generic, inlined, kernel


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
    for name in ("mechanics/a.py", "simulation/steps/b.py", "figures/c.py"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("x = 1\n")
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    digests = [core._digest()]
    for name in ("figures/c.py", "mechanics/a.py", "simulation/steps/b.py"):
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


def test_other_packages_keep_their_cache_folder():
    before = numba.config.CACHE_LOCATOR_CLASSES
    kernel(compiled(lambda x: x))
    assert before == numba.config.CACHE_LOCATOR_CLASSES
    assert "planar_pushing" not in before


def test_a_compiled_function_is_kept_by_its_place_in_the_package(tmp_path, monkeypatch):
    monkeypatch.setattr(core, "PACKAGE", tmp_path)
    here = core.Locator(test_other_packages_keep_their_cache_folder, str(tmp_path / "a/b/c.py"))
    assert Path(here.get_cache_path()) == core.CACHE / "a/b"
    other = core.Locator(test_other_packages_keep_their_cache_folder, __file__)
    assert Path(other.get_cache_path()).parent == core.CACHE


@needs_compiler
def test_a_call_that_compiles_says_so_once(caplog):
    @numba.njit
    def doubled(x):
        return 2 * x

    def call(value):
        caplog.clear()
        with caplog.at_level("INFO", "planar_pushing"), announced(doubled):
            doubled(value)
        return caplog.messages

    ready = core.CACHE
    (message,) = call(1.0)
    assert message.startswith("compiled doubled in 0 s; later runs read it from")
    assert str(ready) in message
    assert call(2.0) == []
    assert len(call(2)) == 1


def test_a_python_function_is_not_announced(caplog):
    with caplog.at_level("INFO", "planar_pushing"), announced(print):
        pass
    assert caplog.messages == []


@inlined
def tripled(x):
    return 3.0 * x


@kernel
@compiled
def raised(x):
    return tripled(x) + 1.0


def test_an_inlined_function_is_a_part_of_its_caller():
    assert raised(2.0) == tripled(2.0) + 1.0 == 7.0
