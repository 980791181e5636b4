"""The body of a function: the kinds of its variables and expressions, and its text in Cython."""

from __future__ import annotations

import ast
import copy
from typing import cast

from .language import (
    ARITHMETIC,
    BUILTINS,
    COMPARISON,
    EQUALITY,
    EXACT,
    INSTEAD,
    MATH,
    NUMBER,
    Kind,
    elements,
    in_c,
    is_docstring,
    name_of,
    spell,
)  # fmt: skip
from .names import Names

Typed = tuple[Kind, ast.expr]


class Body:
    """A function, which the constructor translates."""

    def __init__(self, names: Names, function: ast.FunctionDef) -> None:
        self.names, self.refuse = names, names.refuse
        self.name, (kinds, self.result) = function.name, names.signatures[function.name]
        self.arguments = [argument.arg for argument in function.args.args]
        self.locals: dict[str, Kind] = dict(zip(self.arguments, kinds, strict=True))
        #: Rows of zeros on the stack and their sizes.
        self.rows: dict[str, int] = {}
        #: Whether it writes into an array that it was passed, and to which functions it passes one.
        self.writes, self.callees = False, set[str]()
        self.tree = ast.Module(self._statements(function.body), [])

    def text(self) -> str:
        """The function in Cython."""
        types = {
            name: f"double {name}[{self.rows[name]}]"
            if name in self.rows
            else f"{in_c(kind)} {name}"
            for name, kind in self.locals.items()
        }
        arguments = ", ".join(types.pop(name) for name in self.arguments)
        lines = ast.unparse(ast.fix_missing_locations(self.tree)).splitlines()
        head = f"cdef {in_c(self.result)} {self.name}({arguments}) noexcept nogil:"
        return "\n    ".join([head, *(f"cdef {declared}" for declared in types.values()), *lines])

    # Statements

    def _statements(self, nodes: list[ast.stmt]) -> list[ast.stmt]:
        """The statements of a block."""
        return [new for node in nodes for new in self._statement(node)] or [ast.Pass()]

    def _statement(self, node: ast.stmt) -> list[ast.stmt]:
        """A statement, translated in place; some become none or several."""
        match node:
            case ast.Pass() | ast.Break() | ast.Continue():
                pass
            case ast.Expr(value=ast.Call()):
                node.value = self._infer(node.value)[1]
            case ast.Expr() if is_docstring(node):
                return []
            case ast.AnnAssign(target=ast.Name(id=name) as target, value=value):
                kind = self.names.kind(node.annotation)
                self._match(node, kind, self.locals.setdefault(name, kind), name)
                if value is None:
                    return []
                new = ast.Assign([target], value)
                new.path = node.path  # type: ignore[attr-defined]
                return self._statement(ast.copy_location(new, node))
            case ast.Assign(targets=[target], value=value) if all(map(_is_zeros, elements(value))):
                if len(elements(target)) != len(elements(value)):
                    self.refuse(node, "rows of zeros for another number of names")
                return [*map(self._row, elements(target), elements(value))]
            case ast.Assign():
                kind, node.value = self._translate_all(node.value)
                node.targets = [self._assign(target, kind) for target in node.targets]
            case ast.AugAssign(target=ast.Name() | ast.Subscript() | ast.Attribute() as target):
                before = self._infer(copy.deepcopy(target))[0]
                kind, node.value = self._infer(node.value)
                kind = self._arithmetic(node, node.op, before, kind)
                self._match(node, kind, before, ast.unparse(target))
                node.target = cast(ast.Subscript, self._assign(target, before))
            case ast.If() | ast.While():
                node.test = self._require(node.test, "bool", "condition")
                node.body = self._statements(node.body)
                if node.orelse and isinstance(node, ast.While):
                    self.refuse(node, "else of a loop")
                node.orelse = self._statements(node.orelse) if node.orelse else []
            case ast.For(
                target=ast.Name(), orelse=[],
                iter=ast.Call(func=ast.Name(id="range"), args=[_, *others] as bounds, keywords=[]),
            ):  # fmt: skip
                bounds[:] = [self._require(bound, "int", "bound") for bound in bounds]
                if len(others) > 1 and not ast.unparse(bounds[2]).lstrip("-").isdigit():
                    self.refuse(node, "step of range() that is not a literal")
                self._assign(node.target, "int")
                node.body = self._statements(node.body)
            case ast.Return(value=value):
                result: Kind = "None"
                if value is not None:
                    result, node.value = self._translate_all(value)
                self._match(node, result, self.result, "result")
            case _:
                self.refuse(node, name_of(node))
        return [node]

    def _row(self, target: ast.expr, value: ast.expr) -> ast.stmt:
        """A row of zeros, which is an array on the stack."""
        name, size = ast.unparse(target), 0
        if name in self.locals and (name in self.rows or self.locals[name] != "Numbers"):
            self.refuse(target, f"{name} = zeros(...) where {name} has another value")
        if isinstance(value, ast.Call) and len(value.args) == 1:
            try:
                size = self.names.evaluate(value.args[0])
            except (ArithmeticError, NameError, TypeError, ValueError):
                size = 0
        if not isinstance(size, int) or not 0 < size <= 10_000 or not isinstance(target, ast.Name):
            self.refuse(target, f"{name} = {ast.unparse(value)} without a name or a constant size")
        self.locals[name], self.rows[name] = "Numbers", size
        return ast.parse(f"memset({name}, 0, {8 * size})").body[0]

    def _translate_all(self, node: ast.expr) -> Typed:
        """The kind and the translation of what is assigned or returned, which can be a tuple."""
        if not isinstance(node, ast.Tuple):
            return self._infer(node)
        pairs = [self._infer(member) for member in node.elts]
        node.elts = [new for _, new in pairs]
        return tuple(str(kind) for kind, _ in pairs), node

    def _assign(self, target: ast.expr, kind: Kind) -> ast.expr:
        """The translated target of an assignment of a value of a kind."""
        match target:
            case ast.Name(id=name):
                if name in self.rows or kind == "None":
                    self.refuse(target, f"{name} = ... where it is a row of zeros, or has no value")
                self._match(target, kind, self.locals.setdefault(name, kind), name)
            case ast.Tuple(elts=members):
                if isinstance(kind, str) or len(kind) != len(members):
                    if kind != "?":
                        self.refuse(target, f"{spell(kind)} for {len(members)} names")
                    kind = ("?",) * len(members)
                target.elts = [*map(self._assign, members, kind)]
            case ast.Attribute(value=record, attr=field):
                owner, new = self._infer(record)
                place, expected = self.names.records.get(str(owner), {}).get(field, (0, "?"))
                if expected not in ("float", "int", "bool"):
                    self.refuse(target, f"assignment to {ast.unparse(target)}")
                self._match(target, kind, expected, ast.unparse(target))
                self.writes |= _origin(record) not in self.rows
                return _entry(new, place)
            case ast.Subscript(value=array):
                if kind not in ("?", "float", "int", "bool") or isinstance(target.slice, ast.Slice):
                    self.refuse(target, f"{spell(kind)} in an array of numbers")
                if not self.names.is_a(self._infer(copy.deepcopy(array))[0], "Numbers"):
                    self.refuse(target, f"assignment to {ast.unparse(target)}")
                self.writes |= _origin(target) not in self.rows
                return self._infer(target)[1]
            case _:
                self.refuse(target, f"assignment to {ast.unparse(target)}")
        return target

    # Expressions

    def _match(self, node: ast.AST, kind: Kind, other: Kind, what: str) -> None:
        """Refuse a kind where another is expected."""
        known = "?" not in (kind, other) and "?" not in (*kind, *other)
        if known and not self.names.is_a(kind, other):
            self.refuse(node, f"{what} is {spell(kind)}, not {spell(other)}")

    def _require(self, node: ast.expr, kind: Kind, what: str) -> ast.expr:
        """An expression that must be of a kind."""
        actual, new = self._infer(node)
        self._match(node, actual, kind, what)
        return new

    def _arithmetic(self, node: ast.AST, operation: ast.operator, left: Kind, right: Kind) -> Kind:
        """The kind of a sum, difference, product or quotient."""
        if not {left, right} <= NUMBER or not isinstance(operation, ARITHMETIC):
            sign = type(operation).__name__.lower()
            return self.refuse(node, f"{sign} of {spell(left)} and {spell(right)}")
        if "?" in (left, right):
            return "?"
        if "float" in (left, right):
            return "float"
        return self.refuse(node, "quotient of two int") if isinstance(operation, ast.Div) else "int"

    def _floor_division(self, node: ast.BinOp, left: Kind, right: Kind) -> Typed:
        """An integer quotient rounded down; C rounds toward zero, and division by zero ends the process."""
        positive = ast.unparse(node.right).strip("0").isdigit()
        if not {left, right} <= {"?", "int"} or not positive:
            kinds = f"{spell(left)} and {spell(right)}"
            return self.refuse(node, f"// of {kinds}, not of int and a positive constant"), node
        return "int", ast.Call(ast.Name("floor_div_"), [node.left, node.right], [])

    def _infer(self, node: ast.expr) -> Typed:
        """The kind of an expression, and the expression in Cython."""
        match node:
            case ast.Constant(value=bool() | int() | float() as value):
                return type(value).__name__, node
            case ast.Name(id=name) if name in self.locals:
                return self.locals[name], node
            case ast.Name(id=name) if name in self.names.constants:
                value = self.names.constants[name]
                if isinstance(value, int):
                    return "int", ast.Constant(value)
                return {float: "float", tuple: "Coefficients"}.get(type(value), "?"), node
            case ast.Name(id=name):
                return self.refuse(node, f"{name} has no value here"), node
            case ast.UnaryOp(op=ast.USub()):
                kind, node.operand = self._infer(node.operand)
                return kind if kind in NUMBER else self.refuse(node, f"minus {spell(kind)}"), node
            case ast.UnaryOp(op=ast.Not()):
                node.operand = self._require(node.operand, "bool", "operand of not")
                return "bool", node
            case ast.BinOp():
                left, node.left = self._infer(node.left)
                right, node.right = self._infer(node.right)
                if isinstance(node.op, ast.FloorDiv):
                    return self._floor_division(node, left, right)
                return self._arithmetic(node, node.op, left, right), node
            case ast.BoolOp(values=values):
                values[:] = [self._require(value, "bool", "operand of and, or") for value in values]
                return "bool", node
            case ast.Compare():
                return self._comparison(node), node
            case ast.IfExp():
                node.test = self._require(node.test, "bool", "condition")
                kind, node.body = self._infer(node.body)
                node.orelse = self._require(node.orelse, kind, "second choice")
                return kind, node
            case ast.Attribute(attr=field):
                kind, node.value = self._infer(node.value)
                if kind in self.names.records:
                    return self._field(node, str(kind))
                fields = self.names.structs.get(str(kind), {})
                if field in fields or kind == "?":
                    return fields.get(field, "?"), node
                return self.refuse(node, f"field {field} of {spell(kind)}"), node
            case ast.Subscript():
                return self._part(node)
            case ast.Call(func=ast.Name(id=name) as function) if name not in self.locals:
                return self._call(node, function)
        return self.refuse(node, name_of(node)), node

    def _field(self, node: ast.Attribute, record: str) -> Typed:
        """A field of a record, or all its numbers."""
        if node.attr == "row":
            return "Numbers", node.value
        places = self.names.records[record]
        if node.attr not in places:
            return self.refuse(node, f"field {node.attr} of {record}"), node
        place, kind = places[node.attr]
        number = _entry(node.value, place)
        if kind == "int":
            return kind, ast.Call(ast.Name("int_"), [number], [])
        if kind == "bool":
            return kind, ast.Compare(number, [ast.NotEq()], [ast.Constant(0.0)])
        if kind == "float":
            return kind, number
        return kind, ast.BinOp(node.value, ast.Add(), ast.Constant(place))

    def _comparison(self, node: ast.Compare) -> Kind:
        """The kind of a comparison; numbers are compared in any way, truth values only for equality."""
        pairs = [self._infer(value) for value in (node.left, *node.comparators)]
        node.left, *node.comparators = (new for _, new in pairs)
        kinds = {kind for kind, _ in pairs}
        signs, allowed = (EQUALITY, {"?", "bool"}) if "bool" in kinds else (COMPARISON, NUMBER)
        if not kinds <= allowed or not all(isinstance(sign, signs) for sign in node.ops):
            self.refuse(node, f"comparison of {' and '.join(spell(kind) for kind, _ in pairs)}")
        return "bool"

    def _part(self, node: ast.Subscript) -> Typed:
        """An element of an array, or the part of an array from an index on."""
        kind, node.value = self._infer(node.value)
        start: ast.expr | None = node.slice
        if isinstance(node.slice, ast.Slice):
            start = None if node.slice.upper or node.slice.step else node.slice.lower
        if self.names.is_a(kind, "Numbers"):
            kind = "Numbers"
        if kind not in ("?", "Numbers", "Coefficients"):
            return self.refuse(node, f"part of {spell(kind)}"), node
        if start is None or (start is not node.slice and kind == "Coefficients"):
            return self.refuse(node, "slice other than row[k:] of Numbers"), node
        new = self._require(start, "int", "index")
        if ast.unparse(new).startswith("-"):
            self.refuse(node, "index from the end")
        if start is not node.slice:
            return kind, ast.BinOp(node.value, ast.Add(), new)
        node.slice = new
        return "float", node

    def _call(self, node: ast.Call, function: ast.Name) -> Typed:
        """A call of a named tuple or of a function."""
        name, names = function.id, self.names
        if name == "len" and len(node.args) == 1:
            value = names.constants.get(ast.unparse(node.args[0]))
            if isinstance(value, tuple):
                return "int", ast.Constant(len(value))
        if node.keywords and not self._order_arguments(node, name):
            return self.refuse(node, f"arguments of {name} by other names than its own"), node
        pairs = [self._infer(argument) for argument in node.args]
        kinds: list[Kind] = [kind for kind, _ in pairs]
        rows = [_origin(argument) in self.rows for argument in node.args]
        node.args = [new for _, new in pairs]
        if name in MATH or name in BUILTINS:
            return self._standard(node, function, kinds), node
        result: Kind = name
        if name in names.records:
            if len(kinds) != 1 or not names.is_a(kinds[0], "Numbers"):
                self.refuse(node, f"{name} of anything but one row of numbers")
            return name, node.args[0]
        if name in names.structs:
            expected = list(names.structs[name].values())
            if any(rows) or any(_origin(argument) in self.rows for argument in node.args):
                self.refuse(node, f"row of zeros in a {name}; pass it to a function that makes one")
        elif name in names.signatures:
            expected, result = names.signatures[name]
            if any(self._refers(kind) and not row for kind, row in zip(kinds, rows, strict=True)):
                self.callees.add(name)
        else:
            remedy = f"; write {INSTEAD[name]}" if name in INSTEAD else ""
            return self.refuse(node, f"call of {name}{remedy}"), node
        if len(kinds) != len(expected):
            self.refuse(node, f"{len(kinds)} arguments of {name}, not {len(expected)}")
        for i, (kind, other) in enumerate(zip(kinds, expected, strict=False), 1):
            self._match(node, kind, other, f"argument {i} of {name}")
        return result, node

    def _order_arguments(self, node: ast.Call, name: str) -> bool:
        """Put arguments that are given by name in their places; return whether each has one."""
        arguments = [*self.names.structs.get(name, {})]
        if name in self.names.functions:
            arguments = [argument.arg for argument in self.names.functions[name].args.args]
        values = {keyword.arg: keyword.value for keyword in node.keywords}
        rest = arguments[len(node.args) :]
        if {*values} != {*rest} or len(values) != len(node.keywords):
            return False
        node.args += [values[argument] for argument in rest]
        node.keywords = []
        return True

    def _standard(self, node: ast.Call, function: ast.Name, kinds: list[Kind]) -> Kind:
        """A call of a standard function, which is renamed where C has a different one of that name."""
        name = function.id
        allowed = NUMBER | {"bool"} if name in ("int", "float") else NUMBER
        if len(kinds) != (MATH | BUILTINS)[name] or not {*kinds} <= allowed:
            return self.refuse(node, f"{name}({', '.join(map(spell, kinds))})")
        if name in ("min", "max"):
            self._match(node, kinds[1], kinds[0], f"second argument of {name}")
            function.id = f"{name}_{kinds[0]}_"
            return kinds[0]
        if name in BUILTINS or name in ("floor", "ceil"):
            function.id = f"{name}_"
            return "float" if name == "float" else "int"
        if name not in EXACT and isinstance(node.args[0], ast.Constant):
            self.refuse(node, f"{name} of a literal, which the C compiler rounds in its own way")
        return "float"

    def _refers(self, kind: Kind) -> bool:
        """Whether a value of a kind refers to an array."""
        return self.names.is_a(kind, "Numbers") or any(
            map(self._refers, self.names.structs.get(str(kind), {}).values())
        )


def _is_zeros(node: ast.expr) -> bool:
    """Whether an expression creates a row of zeros."""
    return isinstance(node, ast.Call) and ast.unparse(node.func) == "zeros"


def _entry(row: ast.expr, place: int) -> ast.Subscript:
    """A number of a row."""
    return ast.Subscript(row, ast.Constant(place))


def _origin(node: ast.expr) -> str:
    """The name at the beginning of an expression such as `row[3:][k]` or `solution.force.x`."""
    while isinstance(node, ast.Subscript | ast.Attribute):
        node = node.value
    return ast.unparse(node)
