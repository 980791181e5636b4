"""The order of evaluation, which is from left to right in Python and unspecified in C."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from .bodies import Body
from .names import Names


def check_order(names: Names, bodies: list[Body]) -> None:
    """Refuse expressions in which one operand writes into an array and another may read it."""
    callers = {body.name: body.callees for body in bodies}
    writers = {body.name for body in bodies if body.writes}
    while more := {name for name, callees in callers.items() if callees & writers} - writers:
        writers |= more
    for body in bodies:
        for node in ast.walk(body.tree):
            operands = [*_operands(node)]
            writing = any(_calls(operand, writers) for operand in operands)
            if writing and sum(_calls(operand, callers, ast.Subscript) for operand in operands) > 1:
                names.refuse(node, "array read and written in one expression; write two statements")


def _operands(node: ast.AST) -> Iterable[ast.AST]:
    """The operands of an expression, which C evaluates in any order."""
    match node:
        case ast.BinOp(left=left, right=right) | ast.AugAssign(target=left, value=right):
            return [left, right]
        case ast.Compare(left=left, comparators=others):
            return [left, *others]
        case ast.Call(args=arguments):
            return arguments
        case ast.Assign(targets=targets, value=value):
            nodes = [part for target in targets for part in ast.walk(target)]
            return [value, *(part.slice for part in nodes if isinstance(part, ast.Subscript))]
    return []


def _calls(node: ast.AST, names: Iterable[str], *kinds: type[ast.AST]) -> bool:
    """Whether an expression calls one of the functions, or has a part of a kind."""
    return any(
        isinstance(part, kinds) or (isinstance(part, ast.Call) and ast.unparse(part.func) in names)
        for part in ast.walk(node)
    )
