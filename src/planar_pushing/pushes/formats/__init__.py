"""Readers of published and of own files of pushes."""
