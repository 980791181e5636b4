"""Datasets in files: how they are stored, opened, cut into parts and joined."""
