"""The ledger of claims: the statements of the paper and of this work, their checks, and the verdicts."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
