"""Single changes of the core: signs, comparisons, indices, constants, and guards that are dropped.

A change replaces one expression. Those of a kind are ordered by a digest of the seed and their text, so
that an edit of the core leaves the others selected as they are.
"""

from __future__ import annotations

import ast
import copy
import hashlib
import itertools
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

#: Opposite operators, and comparisons with the boundary included or left out, or turned around.
SIGNS = {ast.Add: ast.Sub, ast.Sub: ast.Add}
BOUNDARIES = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}
OPPOSITES = {
    ast.Lt: ast.Gt, ast.LtE: ast.GtE, ast.Gt: ast.Lt, ast.GtE: ast.LtE,
    ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
}  # fmt: skip
#: Parts of a record that may be taken for each other.
FIELDS = {"x": "y", "y": "x", "left": "right", "right": "left"}
#: Calls whose arguments have to be constants of the language.
FIXED = {"zeros", "size_of", "len", "float"}
KINDS = ("sign", "comparison", "index", "constant", "guard")
#: Changes that are always made, as function, expression and its replacement, beside those of the seed.
ALWAYS = [
    ("_hold_on_verge", "-load.spin - rest * (still.weight_y / still.weight)",
     "-load.spin + rest * (still.weight_y / still.weight)"),
    ("reaction_of", "1.0 / system.scene.mass + square / system.run.moment",
     "1.0 / system.scene.mass - square / system.run.moment"),
    ("pivot_psi", "slack * rest.xs + turns * n_x", "slack * rest.xs - turns * n_x"),
    ("is_between_ends", "force_at_start(side, force) >= -noise and force_at_end(side, force) >= -noise",
     "force_at_start(side, force) >= -noise"),
    ("is_between_ends", "force_at_start(side, force) >= -noise and force_at_end(side, force) >= -noise",
     "force_at_end(side, force) >= -noise"),
    ("choose_twist", "right if point == right else left", "left if point == right else right"),
    ("sample_of", "root.xy * d_x + root.yy * d_y", "root.xy * d_x - root.yy * d_y"),
]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Change:
    """One expression of the core and what replaces it.

    Attributes
    ----------
    path : Path
        The module, relative to the folder of the core.
    function, kind, old, new : str
        The function, one of `KINDS`, and the source of both expressions.
    line : int
        In the original module.
    node, changed : ast.expr
        The expression in the tree of its module, and its replacement.
    """

    path: Path
    function: str
    kind: str
    old: str
    new: str
    line: int
    node: ast.expr
    changed: ast.expr
    number: int = 0

    def name(self) -> str:
        """The text by which a change is known."""
        return f"{self.path}, {self.function}: {self.old} -> {self.new}"


def changes_of(trees: dict[Path, ast.Module]) -> list[Change]:
    """All changes of the modules of a core."""
    return [
        change
        for path, tree in trees.items()
        for function in tree.body
        if isinstance(function, ast.FunctionDef)
        for change in _changes_in(path, function)
    ]


def select_changes(changes: list[Change], seed: int, count: int) -> list[Change]:
    """The changes made always, then the same number of each kind, in an order that the seed decides."""
    texts, occurrences, order = Counter[str](), dict[int, int](), dict[int, str]()
    for change in changes:
        occurrences[id(change)] = texts[change.name()]
        texts[change.name()] += 1
        text = f"{seed} {change.name()} {occurrences[id(change)]}"
        order[id(change)] = hashlib.sha256(text.encode()).hexdigest()
    chosen = [each for each in changes if (each.function, each.old, each.new) in ALWAYS]
    for kind in KINDS:
        ranked = sorted((each for each in changes if each.kind == kind), key=lambda x: order[id(x)])
        chosen += itertools.islice(
            (each for each in ranked if each not in chosen), count // len(KINDS)
        )
    return [replace(each, number=k) for k, each in enumerate(chosen, 1)]


def _changes_in(path: Path, function: ast.FunctionDef) -> Iterator[Change]:
    """The changes of a function, all that its language allows."""
    for part in _parts(function):
        match part:
            case ast.AugAssign(op=ast.Add() | ast.Sub() as operator, value=node):
                old, opposite = ast.unparse(part), _with(part, op=SIGNS[type(operator)]())
                made = [("sign", ast.UnaryOp(ast.USub(), node), old, ast.unparse(opposite))]
            case ast.If(test=node, body=[ast.Return() | ast.Break() | ast.Continue()], orelse=[]):
                old = ast.unparse(part).replace("\n   ", "")
                made = [("guard", ast.Constant(False), old, "nothing")]
            case ast.expr():
                node, old = part, ast.unparse(part)
                made = [(kind, new, old, ast.unparse(new)) for kind, new in _replacements(part)]
            case _:
                continue
        for kind, changed, old, new in made:
            yield Change(
                path=path, function=function.name, kind=kind, old=old, new=new, line=part.lineno,
                node=node, changed=changed,
            )  # fmt: skip


def _parts(node: ast.AST) -> Iterator[ast.AST]:
    """The parts of a function that compute; without annotations, and what must be a constant."""
    for field, value in ast.iter_fields(node):
        if field in ("annotation", "returns", "args") and not isinstance(node, ast.Call):
            continue
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.FloorDiv) and field == "right":
            continue
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, ast.AST) and not _is_fixed(part):
                yield part
                yield from _parts(part)


def _is_fixed(node: ast.AST) -> bool:
    """Whether a call has to be as it is, because its arguments must be constants."""
    return isinstance(node, ast.Call) and ast.unparse(node.func) in FIXED


def _replacements(node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """The replacements of one expression, with their kinds."""
    match node:
        case ast.BinOp(op=ast.Add() | ast.Sub() as operator):
            yield "sign", _with(node, op=SIGNS[type(operator)]())
        case ast.UnaryOp(op=ast.USub()) if not isinstance(node.operand, ast.Constant):
            yield "sign", copy.deepcopy(node.operand)
        case ast.Call(func=ast.Name(id="fabs")):
            yield "sign", copy.deepcopy(node.args[0])
        case ast.Call(func=ast.Name(id="min" | "max" as name)):
            other = ast.Name("max" if name == "min" else "min")
            yield "comparison", _with(node, func=other)
        case ast.Compare(ops=[operator, *rest]):
            for table in (BOUNDARIES, OPPOSITES):
                if type(operator) in table:
                    yield "comparison", _with(node, ops=[table[type(operator)](), *rest])
        case ast.IfExp():
            yield "guard", _with(node, body=node.orelse, orelse=node.body)
        case ast.BoolOp(values=values):
            for k in range(len(values)):
                rest = [*values[:k], *values[k + 1 :]]
                yield "guard", _with(node, values=rest) if len(rest) > 1 else rest[0]
        case ast.Attribute(attr=field, ctx=ast.Load()) if field in FIELDS:
            yield "index", _with(node, attr=FIELDS[field])
        case ast.Subscript(slice=ast.Constant(value=int() as value), ctx=ast.Load()):
            yield "index", _with(node, slice=ast.Constant(value - 1 if value else 1))
        case ast.Constant(value=bool() as value):
            yield "constant", ast.Constant(not value)
        case ast.Constant(value=float() as value):
            yield "constant", ast.Constant(1.0 if value == 0.0 else 2.0 * value)
        case ast.Constant(value=int() as value):
            yield "constant", ast.Constant(value + 1)


def _with(node: ast.AST, **parts: object) -> ast.expr:
    """A copy of an expression with other parts."""
    new = copy.deepcopy(node)
    for field, value in parts.items():
        setattr(new, field, copy.deepcopy(value))
    return new
