"""The figures: their drawings in four folders; the one place that knows matplotlib."""

from planar_pushing.terms.extras import require_extra

require_extra("figures")
