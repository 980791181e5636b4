"""Cells of datasets that the oracle certifies: what each asks, and the answer in balls."""
