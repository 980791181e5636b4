"""The cost of accuracy and of each effect: errors, counts of evaluations, and times."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
