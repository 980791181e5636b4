"""Claims about any slider that the mechanics decide; importing the package registers their checks."""

from planar_pushing.evidence.claims.any_slider import gallery as gallery
from planar_pushing.evidence.claims.any_slider import random_pushes as random_pushes
