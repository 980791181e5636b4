"""Stub."""

from __future__ import annotations

STICK_CASE, SLIP_CASE, LINE_CASE, FORCE_CASE, FREE_CASE = range(5)
FIRST = 5
