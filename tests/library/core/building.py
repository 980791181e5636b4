"""Run the build of the core on other folders, and load what it makes."""

import importlib.util
import itertools
import shutil
import sys
from pathlib import Path

from core.made_up import MODULES

import planar_pushing.core
import planar_pushing.core._record  # stays where it is while modules of another folder are loaded

CORE = Path(planar_pushing.core.__file__).parent
PROJECT = CORE.parents[2]
NUMBER = itertools.count()


def load(name, path):
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


hook = load("hook", PROJECT / "joiner/hook.py")


def write(folder, modules=MODULES):
    """A core with given modules and the module `numbers` of the real one."""
    folder.mkdir(exist_ok=True)
    shutil.copy(CORE / "numbers.py", folder)
    for name, text in modules.items():
        path = folder / f"{name}.py"
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def compiled(folder):
    """The compiled module of a folder."""
    target = hook.build(folder)
    return load(f"made_up_{next(NUMBER)}._compiled", target)


def plain(folder, monkeypatch):
    """The modules of a folder as they are, in the place of those of the core."""
    parts = [path.relative_to(folder).with_suffix("").parts for path in folder.rglob("*.py")]
    names = {".".join(part) for part in parts} - {"numbers"}
    for name in names:
        monkeypatch.delitem(sys.modules, f"planar_pushing.core.{name}", raising=False)
    monkeypatch.setattr(planar_pushing.core, "__path__", [str(folder)])
    return {name: importlib.import_module(f"planar_pushing.core.{name}") for name in sorted(names)}
