"""Pictures of scenes and of motion: lists of marks, drawn by matplotlib or written as SVG."""

import os
from importlib.util import find_spec

from planar_pushing.terms.extras import require_extra

require_extra("figures")

# Jupyter sets a backend for every command that it starts, and matplotlib cannot be imported if the module
# of that backend is not installed. Pictures are files and need no backend, so the setting is removed.
_kind, _, _module = os.environ.get("MPLBACKEND", "").partition("://")
if _kind == "module" and find_spec(_module.partition(".")[0]) is None:
    del os.environ["MPLBACKEND"]
