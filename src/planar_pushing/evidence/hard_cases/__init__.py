"""Hard cases: where the numbers get hard, each with its reference, its error and its condition."""
