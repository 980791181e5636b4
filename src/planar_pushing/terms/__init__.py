"""The words that every room shares: errors, options, units, and the ranges of parameters."""
