"""Identities, lemmas and interval arguments of which the checks are composed."""
