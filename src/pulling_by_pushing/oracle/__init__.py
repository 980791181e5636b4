"""Proofs of the library's answers in ball arithmetic; nothing here imports the mechanics.

A support enters only by its mean distance from a center of rotation, with gradient and Hessian
(`support`); the chain rule makes the wrench and its Jacobian of it (`body`). An answer is the root of a
small system of equations next to a guess, proved by interval Newton (`prove`). Angles are in exact
degrees, doubles are exact, and vectors are in the frame of the rod: x along the rod, away from the
contact, which is at (-length, 0).
"""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
