"""Count the evaluations of a study, which standard input holds, anew; the parent reads them from output."""

from __future__ import annotations

import pickle
import sys

from planar_pushing.evidence.costs.effects import evaluations


def main() -> int:
    """Write the counts."""
    sys.stdout.buffer.write(pickle.dumps(evaluations(pickle.load(sys.stdin.buffer))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
