"""The numerical core, mechanics and motion over time: plain typed Python, compiled when it is installed.

The modules of this folder share one namespace and a small subset of Python: named tuples, and functions of
floats, integers, truth values and arrays. ``joiner`` translates them into one compiled module. They also
run as plain Python, with the same results to the last bit. All lengths are in radii of the slider. Twists
and wrenches are about the origin of the body frame and in that frame: origin at the slider's center, x
along the rod and away from the contact.
"""

import hashlib
from collections.abc import Sequence
from pathlib import Path

#: Files of the modules.
MODULES = sorted(Path(__file__).parent.glob("[!_]*.py"))


def digest(paths: Sequence[Path] = MODULES) -> str:
    """A digest of source files; the compiled module stores that of the sources from which it was built."""
    texts = (path.read_bytes() for path in paths)
    return hashlib.sha256(b"\0".join(texts)).hexdigest()
