"""Proofs of claims: the protocol that a proof asks, its verdicts, and arguments shared by several."""

from planar_pushing.terms.extras import require_extra

require_extra("golden")
