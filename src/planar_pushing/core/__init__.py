"""The mechanics in numbers: plain typed Python, which is compiled when the package is installed.

The modules of this folder are one name space in a small language, which ``hatch_build.py`` translates into
one compiled module: named tuples and functions of floats, integers, truth values and arrays. They also run
as they are, with the same results to the last bit. All lengths are in radii of the slider, and twists and
wrenches are those of the body frame's origin, in the body frame: origin at the slider's center, x along the
rod and away from the contact.
"""
