"""The language of the core: its types, its functions, and the terms of messages about it."""

from __future__ import annotations

import ast

#: "float", the name of a named tuple, several kinds in a tuple, or "?" after a refusal.
Kind = str | tuple[str, ...]
#: Kinds and their types in C; `Coefficients` is an array of constants.
C = {
    "float": "double", "int": "long", "bool": "bint", "None": "void",
    "Numbers": "double*", "Coefficients": "double*",
}  # fmt: skip
#: What the module `numbers` defines for plain Python only, because Cython has it already.
PROVIDED = {"Numbers", "Coefficients", "Record", "size_of", "zeros"}
#: Functions and their numbers of arguments. The C compiler evaluates those of `EXACT` as Python does.
EXACT = {"sqrt": 1, "fabs": 1, "floor": 1, "ceil": 1, "copysign": 2}
MATH = (
    EXACT | dict.fromkeys(("sin", "cos", "asin", "log", "exp", "sinh", "asinh"), 1) | {"atan2": 2}
)
BUILTINS = {"int": 1, "float": 1, "min": 2, "max": 2}
RESERVED = {*C, *MATH, *BUILTINS, *PROVIDED, "len", "range"}
INSTEAD = {"abs": "fabs", "hypot": "sqrt(x * x + y * y)", "isnan": "x != x", "pow": "x * x"}

NUMBER = {"?", "float", "int"}
ARITHMETIC = (ast.Add, ast.Sub, ast.Mult, ast.Div)
EQUALITY = (ast.Eq, ast.NotEq)
COMPARISON = (*EQUALITY, ast.Lt, ast.LtE, ast.Gt, ast.GtE)


class RefusedSource(Exception):
    """Source code outside the language of the core; the message has one line for each place."""


def in_c(kind: Kind) -> str:
    """The type of a kind in C."""
    return C.get(kind, kind) if isinstance(kind, str) else f"({', '.join(map(in_c, kind))})"


def spell(kind: Kind) -> str:
    """A kind as it is written in Python."""
    return kind if isinstance(kind, str) else f"tuple[{', '.join(kind)}]"


def name_of(node: ast.AST) -> str:
    """The name of a statement or an expression in messages."""
    names = {
        "FunctionDef": "function", "ClassDef": "class", "Assign": "assignment", "JoinedStr": "text",
        "AugAssign": "augmented assignment", "Constant": "constant that is no number",
        "Expr": "expression without effect", "For": "loop over anything but range(...)",
    }  # fmt: skip
    return names.get(type(node).__name__, type(node).__name__.lower())


def elements(node: ast.expr) -> list[ast.expr]:
    """The elements of a tuple, or the expression itself."""
    return node.elts if isinstance(node, ast.Tuple) else [node]


def is_docstring(node: ast.AST) -> bool:
    """Whether a statement is only a string."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )
