"""The figures: their drawings in four folders; the one place that knows matplotlib."""
