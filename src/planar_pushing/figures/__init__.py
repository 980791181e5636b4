"""The figures and every other picture: a list of marks, drawn by matplotlib or written as SVG."""

from planar_pushing.terms.extras import require_extra

require_extra("figures")
