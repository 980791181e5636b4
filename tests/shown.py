"""Whether a program prints what a page shows."""

import doctest
import re

FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
#: A number with a point, and how many digits one has that shows the whole double.
NUMBER = re.compile(r"\d+\.\d+(?:e[+-]?\d+)?")
WHOLE, SURE = 15, 14


class Checker(doctest.OutputChecker):
    """Compares what is shown and printed; of a whole double all digits but the last ones.

    They are rounding, which depends on the processor.
    """

    def check_output(self, want, got, optionflags):
        return super().check_output(_rounded(want), _rounded(got), optionflags)


def _rounded(text):
    return NUMBER.sub(lambda found: _without_rounding(found[0]), text)


def _without_rounding(number):
    digits = number.partition("e")[0].replace(".", "").lstrip("0")
    return f"{float(number):.{SURE}g}" if len(digits) >= WHOLE else number


def agrees(shown, printed):
    """Whether a program has printed what is shown."""
    return Checker().check_output(shown, printed, FLAGS)
