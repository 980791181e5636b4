"""The numerical core, mechanics and motion over time: plain typed Python, compiled when it is installed.

It has three floors, which import downward only: `supports`, the resistance to a twist, up to the reduced
potential; `instant`, one push and all its modes; and `motion`, runs over time. Their modules share one
namespace and a small subset of Python: named tuples, records, and functions of floats, integers, truth
values and arrays. ``joiner`` translates them into one compiled module. They also run as plain Python, with
the same results to the last bit. All lengths are in radii of the slider. Twists and wrenches are about the
origin of the body frame and in that frame: origin at the slider's center, x along the rod and away from the
contact.
"""

import hashlib
from array import array
from collections.abc import Callable, Sequence
from pathlib import Path

#: Files of the modules.
FOLDER = Path(__file__).parent
MODULES = sorted(FOLDER.rglob("[!_]*.py"))
#: Inputs of ``probe``, which the joiner adds to the compiled module, and its results by IEEE 754.
INPUTS = (
    1.0, 1e-17, 1.0 + 2.0**-30, 1.0 + 2.0**-29, 7.0, 5e-324, 2.0**-1022, 1e300, -0.0, float("nan"),
)  # fmt: skip
RESULTS = (0.0, 0.0, 2.3333333333333335, 0.1, 1e-323, 2.0**-1023, float("inf"), 0.0, 1.0)


def digest(paths: Sequence[Path] = MODULES) -> str:
    """A digest of source files; the compiled module stores that of the sources from which it was built."""
    texts = (path.read_bytes() for path in paths)
    return hashlib.sha256(b"\0".join(texts)).hexdigest()


def keeps_bits(probe: Callable[..., tuple[float, ...]]) -> bool:
    """Whether compiled arithmetic has the bits of the source, in sums, products and subnormal numbers."""
    return array("d", probe(*INPUTS)).tobytes() == array("d", RESULTS).tobytes()
