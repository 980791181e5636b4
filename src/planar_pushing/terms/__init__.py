"""Vocabulary shared by all packages: errors, options, units, and ranges of parameters."""
