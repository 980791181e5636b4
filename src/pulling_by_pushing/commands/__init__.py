"""Commands of the paper, which the entry points of the package add to the command line."""
