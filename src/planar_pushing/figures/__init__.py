"""The figures, a module each over shared primitives: the one place that knows matplotlib."""
