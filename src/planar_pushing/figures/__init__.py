"""The figures and every other picture: a list of marks, drawn by matplotlib or written as SVG."""

import os
from importlib.util import find_spec

from planar_pushing.terms.extras import require_extra

require_extra("figures")

# Jupyter names a backend for every command that it starts, and matplotlib cannot be imported where the
# module of that backend is not installed. Pictures are files, which need none: such a name is forgotten.
_kind, _, _module = os.environ.get("MPLBACKEND", "").partition("://")
if _kind == "module" and find_spec(_module.partition(".")[0]) is None:
    del os.environ["MPLBACKEND"]
