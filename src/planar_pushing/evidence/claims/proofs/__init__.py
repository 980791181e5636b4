"""Identities, lemmas and interval arguments from which the checks are composed."""
