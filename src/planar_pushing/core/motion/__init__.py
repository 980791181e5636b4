"""Runs over time: modes that follow one another, between events or in steps."""
