"""Numbers of the results as a page writes them."""

from __future__ import annotations

import re

#: File of numbers by key, in the folder of the tables.
NUMBERS = "numbers.json"
#: Symbols appended to numbers with these units; the text names all other units.
MARKS = {"degree": "°", "percent": " %"}
#: A number with an exponent, and the superscript digits.
POWER = re.compile(r"\b([\d.]+)e([+-]\d+)\b")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def format_number(text: str, unit: str = "") -> str:
    """A number formatted for text: a minus sign, powers of ten, separated thousands, and a symbol."""
    if text.isdigit() and len(text) > 4:
        return f"{int(text):,}".replace(",", "\u202f") + MARKS.get(unit, "")
    return POWER.sub(_power, text).replace("-", "\u2212") + MARKS.get(unit, "")


def _power(power: re.Match[str]) -> str:
    ten = "10" + str(int(power[2])).translate(RAISED)
    return ten if power[1] == "1" else f"{power[1]} \u00d7 {ten}"
