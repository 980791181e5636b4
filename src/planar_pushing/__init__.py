"""Planar pushing: pulling by pushing, slip with infinite friction, and the mechanics behind them."""

import sys
from functools import partial
from importlib import import_module

if sys.platform == "win32":
    raise ImportError("planar-pushing does not run on Windows; use it on Linux or macOS")

import lazy_loader

from planar_pushing.mechanics.pictures import LOADERS

__version__ = "1.0.0"

# The stub beside this file lists the public names; each is imported when it is first used.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

# The pictures that notebooks show; the mechanics knows nothing of figures.
LOADERS.append(partial(import_module, "planar_pushing.drawing.scene"))
