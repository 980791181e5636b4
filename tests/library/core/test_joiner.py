"""The joiner refuses what is not in the language of the core, with file, line and reason."""

import re

import pytest
from core.building import hook, write
from core.made_up import MODULES

HEAD = """
from __future__ import annotations
from math import log, sqrt
from typing import NamedTuple
from planar_pushing.core._record import Record, size_of
from planar_pushing.core.numbers import Numbers, Coefficients, zeros
LINE = (1.0, 2.0)
COUNT = 3
class Pair(NamedTuple):
    x: float
    n: int
class Mark(Record):
    k: int
    at: float
class Held(NamedTuple):
    pair: Pair
    row: Numbers
def store(row: Numbers, x: float) -> float:
    row[0] = x
    return x
def look(row: Numbers) -> float:
    return row[0]
"""

TWICE = "array read and written in one expression; write two statements"
MODULE_LEVEL = {
    "import numpy": "import in a module",
    "from numpy import rint": "import of rint from numpy",
    "from math import hypot": "import of hypot from math",
    "from math import sqrt as root": "import of sqrt from math",
    "from typing import Any": "import of Any from typing",
    "from planar_pushing.core.missing import x": "import of x from planar_pushing.core.missing",
    "from planar_pushing.terms.errors import shown": "import of shown from planar_pushing.terms.errors",
    "from .numbers import zeros": "importfrom in a module",
    "if True: pass": "if in a module",
    "print(1)": "expression without effect in a module",
    "NAME: float = 1.0": "annassign in a module",
    "NAME = 'text'": "constant NAME: only an integer, a float, or a tuple of floats is allowed",
    "NAME = True": "constant NAME: only an integer, a float, or a tuple of floats is allowed",
    "NAME = (1.0, 2)": "constant NAME: only an integer, a float, or a tuple of floats is allowed",
    "NAME = [1.0]": "constant NAME: [1.0] is not arithmetic",
    "NAME = sqrt(2.0)": "constant NAME: sqrt(2.0) is not arithmetic",
    "NAME = 1.0 / 0.0": "constant NAME: float division by zero",
    "NAME = OTHER": "constant NAME: unknown names",
    "A, B = range(3)": "2 names for anything but 2 constants or a range of 2",
    "A, B = range(4, 7)": "2 names for anything but 2 constants or a range of 2",
    "A, B = range(0, 4, 2)": "2 names for anything but 2 constants or a range of 2",
    "A, B = 1, 2, 3": "2 names for anything but 2 constants or a range of 2",
    "A, B = [1, 2]": "2 names for anything but 2 constants or a range of 2",
    "A, B = 1, 'text'": "constant B: only an integer, a float, or a tuple of floats is allowed",
    "COUNT = 4": "COUNT is also defined in snippet.py, line 8",
    "def LINE() -> None: pass": "LINE is also defined in snippet.py, line 7",
    "far = 1.0": "far is also defined in other.py, line 1",
    "def sqrt() -> None: pass": "sqrt is also defined by Python or C",
    "def min_() -> None: pass": "min_ is also defined by Python or C",
    "class X: pass": "class X that is not just a NamedTuple",
    "class X(Pair): pass": "class X that is not just a NamedTuple",
    "class X(Record):\n    x: float = 1.0": "+1 annassign in a record",
    "class X(Record):\n    x: Numbers": "+1 field x of type Numbers",
    "class X(Record):\n    def f(self) -> int: ...": "+1 function in a record",
    "class X(Record):\n    x: X": "class X that is not just a NamedTuple",
    "class X(NamedTuple):\n    x: float = 1.0": "+1 annassign in a NamedTuple",
    "class X(NamedTuple):\n    x: str": "+1 type str",
    "class X(NamedTuple):\n    x: tuple[int, int]": "+1 field x of type tuple[int, int]",
    "class X(NamedTuple):\n    def f(self) -> int: ...": "+1 function in a NamedTuple",
    "class X(NamedTuple):\n    x: Held\n    y: X": "class X that contains itself",
    "async def f() -> None: pass": "asyncfunctiondef in a module",
    "@sqrt\ndef f() -> None: pass": "+1 decorators or type parameters of f",
    "def f(x): pass": "argument x without a type AND no type of the result of f",
    "def f(x: None) -> None: pass": "argument x without a type",
    "def f(x: float): pass": "no type of the result of f",
    "def f(x: float = 1.0) -> None: pass": "arguments of f that are not just names and types",
    "def f(*x: float) -> None: pass": "arguments of f that are not just names and types",
    "def f(*, x: float) -> None: pass": "arguments of f that are not just names and types",
    "def f(x: float, /) -> None: pass": "arguments of f that are not just names and types",
    "def f(**x: float) -> None: pass": "arguments of f that are not just names and types",
    "def f(x: list[float]) -> None: pass": "type list[float]",
    "def f(x: 'float') -> None: pass": "type 'float'",
    "def f(x: float | None) -> None: pass": "type float | None",
    "def f() -> tuple[float, Numbers]: pass": "type tuple[float, Numbers]",
    "def f() -> tuple[float, ...]: pass": "type ...",
}

BODY = {
    "raise x": "raise",
    "assert x > 0.0": "assert",
    "try:\n    pass\nfinally:\n    pass": "try",
    "with x: pass": "with",
    "del x": "delete",
    "global x": "global",
    "import math": "import",
    "def g() -> None: pass": "function",
    "class X: pass": "class",
    "match n:\n    case 1: pass": "match",
    "x": "expression without effect",
    "for y in row: pass": "loop over anything but range(...)",
    "for i in range(n):\n    pass\nelse:\n    pass": "loop over anything but range(...)",
    "for i in range(x): pass": "bound is float, not int",
    "for i in range(0, n, n): pass": "step of range() that is not a literal",
    "while n: pass": "condition is int, not bool",
    "while flag:\n    pass\nelse:\n    pass": "else of a loop",
    "if x: pass": "condition is float, not bool",
    "y = 'text'": "constant that is no number",
    "y = f'{x}'": "text",
    "y = None": "constant that is no number",
    "y = 1j": "constant that is no number",
    "y = [x]": "list",
    "y = {1: x}": "dict",
    "y = {x}": "set",
    "y = [x for i in range(3)]": "listcomp",
    "y = lambda: x": "lambda",
    "y = (z := x)": "namedexpr",
    "y = x ** 2.0": "pow of float and float",
    "n = n // 0": "// of int and int, not of int and a positive constant",
    "n = n // -2": "// of int and int, not of int and a positive constant",
    "n = n // n": "// of int and int, not of int and a positive constant",
    "y = x // 2": "// of float and int, not of int and a positive constant",
    "y = n // 2.0": "// of int and float, not of int and a positive constant",
    "n //= 2": "floordiv of int and int",
    "n = n % 2": "mod of int and int",
    "n = n | 1": "bitor of int and int",
    "n |= 1": "bitor of int and int",
    "y = n / 2": "quotient of two int",
    "n /= 2": "quotient of two int",
    "y = x + flag": "add of float and bool",
    "y = x @ x": "matmult of float and float",
    "row += 1": "add of Numbers and int",
    "y = +x": "unaryop",
    "n = ~n": "unaryop",
    "y = -flag": "minus bool",
    "y = Mark(x)": "Mark of anything but one row of numbers",
    "y = Mark(row).z": "field z of Mark",
    "Mark(row).k = x": "Mark(row).k is float, not int",
    "Mark(row).at += flag": "add of float and bool",
    "Mark(row).z = x": "assignment to Mark(row).z",
    "mark = Mark(row)\nmark = row": "+1 mark is Numbers, not Mark",
    "x = 0": "x is int, not float",
    "n = 0.0": "n is float, not int",
    "n += 1.0": "n is float, not int",
    "y = 0\nif flag:\n    y = 0.0": "+2 y is float, not int",
    "y: float = 0": "y is int, not float",
    "x: int = 0": "x is int, not float",
    "y = x if flag else 0": "second choice is int, not float",
    "y = x if x else x": "condition is float, not bool",
    "y = not x": "operand of not is float, not bool",
    "y = x or x": "operand of and, or is float, not bool",
    "y = x < flag": "comparison of float and bool",
    "y = flag < flag": "comparison of bool and bool",
    "y = x is x": "comparison of float and float",
    "y = n in n": "comparison of int and int",
    "y = pair == pair": "comparison of Pair and Pair",
    "y = row == row": "comparison of Numbers and Numbers",
    "y = unknown": "unknown has no value here",
    "y = LATER": "LATER has no value here",
    "y = pair.z": "field z of Pair",
    "y = x.real": "field real of float",
    "pair.x = 1.0": "assignment to pair.x",
    "pair.x += 1.0": "assignment to pair.x",
    "y = pair[0]": "part of Pair",
    "x, n = pair": "Pair for 2 names",
    "x, n = x": "float for 2 names",
    "x, n = x, n, n": "tuple[float, int, int] for 2 names",
    "(x, n), y = x, x": "float for 2 names",
    "y = (x, n), x": "tuple",
    "y = (x, n) if flag else (x, n)": "tuple",
    "*y, z = x, x": "assignment to *y",
    "y = x, *z": "starred",
    "y = row[1:2]": "slice other than row[k:] of Numbers",
    "y = row[:]": "slice other than row[k:] of Numbers",
    "y = row[::2]": "slice other than row[k:] of Numbers",
    "y = LINE[1:]": "slice other than row[k:] of Numbers",
    "y = row[-1]": "index from the end",
    "y = row[-1:]": "index from the end",
    "y = row[x]": "index is float, not int",
    "y = row[x:]": "index is float, not int",
    "y = x[0]": "part of float",
    "row[0] = row": "Numbers in an array of numbers",
    "row[1:] = x": "float in an array of numbers",
    "LINE[0] = x": "assignment to LINE[0]",
    "y = abs(x)": "call of abs; write fabs",
    "y = hypot(x, x)": "call of hypot; write sqrt(x * x + y * y)",
    "y = isnan(x)": "call of isnan; write x != x",
    "y = sum(row)": "call of sum",
    "y = x(1)": "call",
    "y = row.tolist()": "call",
    "y = look(rows=row)": "arguments of look by other names than its own",
    "y = look(*row)": "starred",
    "y = look()": "0 arguments of look, not 1",
    "y = look(x)": "argument 1 of look is float, not Numbers",
    "y = store(row, 1)": "argument 2 of store is int, not float",
    "y = store(LINE, x)": "argument 1 of store is Coefficients, not Numbers",
    "y = Pair(x)": "1 arguments of Pair, not 2",
    "y = Pair(x, x)": "argument 2 of Pair is float, not int",
    "y = sqrt(flag)": "sqrt(bool)",
    "y = sqrt(x, x)": "sqrt(float, float)",
    "y = log(2.0)": "log of a literal, which the C compiler rounds in its own way",
    "y = min(x, n)": "second argument of min is int, not float",
    "y = max(x, x, x)": "max(float, float, float)",
    "y = min(row)": "min(Numbers)",
    "y = len(row)": "call of len",
    "y = int(row)": "int(Numbers)",
    "y = zeros(n)": "y = zeros(n) without a name or a constant size",
    "y = zeros(0)": "y = zeros(0) without a name or a constant size",
    "y = zeros(100000)": "y = zeros(100000) without a name or a constant size",
    "row = zeros(3)\nrow = zeros(3)": "+1 row = zeros(...) where row has another value",
    "y = zeros(3)\ny = row": "+1 y = ... where it is a row of zeros, or has no value",
    "x = zeros(3)": "x = zeros(...) where x has another value",
    "y = look(zeros(3))": "call of zeros",
    "y, z = zeros(3), x": "call of zeros",
    "y, z = zeros(3)": "rows of zeros for another number of names",
    "y = zeros(2)\nheld = Held(pair, y)": (
        "+1 row of zeros in a Held; pass it to a function that makes one"
    ),
    "y = zeros(2)\nheld = Held(row=y[1:], pair=pair)": (
        "+1 row of zeros in a Held; pass it to a function that makes one"
    ),
    "y = zeros(2)\nheld = Held(pair, Mark(y))": (
        "+1 row of zeros in a Held; pass it to a function that makes one"
    ),
    "y = nothing()": "y = ... where it is a row of zeros, or has no value",
    "y = store(row, x) + row[0]": TWICE,
    "y = look(row) * store(row, x)": TWICE,
    "flag = store(row, x) < store(row, 2.0)": TWICE,
    "row[0] += store(row, x)": TWICE,
    "y = sums(store(row, x), row[0])": TWICE,
    "y = through(held) + row[0]": TWICE,
    "return x": "result is float, not None",
    "return x, x": "result is tuple[float, float], not None",
}

FUNCTION = """
def nothing() -> None:
    return
def sums(x: float, y: float) -> float:
    return x + y
def through(held: Held) -> float:
    return store(held.row[2:], 1.0)
def pure(x: float) -> float:
    y = zeros(2)
    return store(y[1:], x)
def f(x: float, n: int, flag: bool, row: Numbers, pair: Pair, held: Held) -> None:
    pass
"""


def refusals(tmp_path, text):
    folder = write(tmp_path / "core", {"snippet": text, "other": "far = 2.0\n"})
    with pytest.raises(hook.RefusedSource) as refused:
        hook.join(folder)
    matches = [
        re.fullmatch(r"(.*):(\d+): (.*)", line).groups() for line in str(refused.value).split("\n")
    ]
    return [(path.rsplit("/", 1)[-1], int(line), reason) for path, line, reason in matches]


def check(refused, first, expected):
    shift, reasons = re.fullmatch(r"(?:\+(\d+) )?(.*)", expected).groups()
    assert sorted(refused) == sorted(
        ("snippet.py", first + int(shift or 0), reason) for reason in reasons.split(" AND ")
    )


@pytest.mark.parametrize(("text", "expected"), MODULE_LEVEL.items())
def test_a_module_with_a_foreign_construct_is_refused(tmp_path, text, expected):
    check(refusals(tmp_path, HEAD + text + "\n"), HEAD.count("\n") + 1, expected)


@pytest.mark.parametrize(("text", "expected"), BODY.items())
def test_a_function_with_a_foreign_construct_is_refused(tmp_path, text, expected):
    before = HEAD + FUNCTION
    body = "".join(f"    {line}\n" for line in text.split("\n"))
    check(refusals(tmp_path, before + body), before.count("\n") + 1, expected)


def test_a_missing_result_and_a_wrong_one_are_refused(tmp_path):
    text = "def f(n: int) -> int:\n    if n > 0:\n        return\n    return n > 1\n"
    assert refusals(tmp_path, text) == [
        ("snippet.py", 3, "result is None, not int"), ("snippet.py", 4, "result is bool, not int"),
    ]  # fmt: skip


def test_all_refusals_are_told_at_once_in_order(tmp_path):
    text = "import os\ndef f(x: float) -> float:\n    y = x ** 2.0\n    return [y]\n"
    assert refusals(tmp_path, text) == [
        ("snippet.py", 1, "import in a module"),
        ("snippet.py", 3, "pow of float and float"),
        ("snippet.py", 4, "list"),
    ]


@pytest.mark.parametrize("text", [
    "y = store(row, x)", "row[0] = store(row, x)", "y = sums(x, store(row, x))",
    "y = pure(x) + row[0]", "flag = x < 1.0 and store(row, x) > 1.0",
])  # fmt: skip
def test_one_operand_may_write_into_an_array(tmp_path, text):
    body = "".join(f"    {line}\n" for line in text.split("\n"))
    folder = write(tmp_path / "core", {"snippet": HEAD + FUNCTION + body})
    hook.join(folder)


def test_kernels_are_the_functions_with_their_arguments(tmp_path):
    joined = hook.join(write(tmp_path / "core"))
    assert joined.kernels == ["answer"]
    assert "answer_row" in joined.source
    other = MODULES["apex"].replace("results", "result")
    folder = write(tmp_path / "core", MODULES | {"apex": other})
    assert hook.join(folder).kernels == []
