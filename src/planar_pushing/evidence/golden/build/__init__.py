"""The golden data computed from the certified physics."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
