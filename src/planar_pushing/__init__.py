"""Planar pushing: pulling by pushing, slip with infinite friction, and the mechanics behind them."""

import sys
from functools import partial
from importlib import import_module
from typing import Any

if sys.platform == "win32":
    raise ImportError("planar-pushing does not run on Windows; use it on Linux or macOS")

import lazy_loader

from planar_pushing.calls import explain_calls
from planar_pushing.mechanics.pictures import LOADERS
from planar_pushing.terms.errors import suggestion

__version__ = "1.0.0"

# The stub beside this file lists the public names; each is imported when it is first used.
_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    try:
        value = globals()[name] = explain_calls(name, _load(name), _load)
        return value
    except AttributeError:
        if name in __all__:  # its module fails
            raise
        remedy = suggestion(name, __all__, "dir(planar_pushing) lists the names")
        message = f"planar_pushing has no attribute {name}; {remedy}"
        # Without `obj`, a traceback does not repeat the suggestion.
        raise AttributeError(message, name=name) from None


# The pictures that notebooks show; the mechanics knows nothing of figures.
LOADERS.append(partial(import_module, "planar_pushing.drawing.scene"))
