"""The mechanics in numbers: plain typed Python, which is compiled when the package is installed.

The modules of this folder are one name space in a small language, which ``joiner`` translates into
one compiled module: named tuples and functions of floats, integers, truth values and arrays. They also run
as they are, with the same results to the last bit. All lengths are in radii of the slider, and twists and
wrenches are those of the body frame's origin, in the body frame: origin at the slider's center, x along the
rod and away from the contact.
"""

import hashlib
from pathlib import Path


def digest(folder: Path = Path(__file__).parent) -> str:
    """A digest of the modules; the compiled module has that of the text from which it was made."""
    texts = (path.read_bytes() for path in sorted(folder.glob("[!_]*.py")))
    return hashlib.sha256(b"\0".join(texts)).hexdigest()
