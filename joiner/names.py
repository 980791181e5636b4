"""The names of all modules: named tuples, records, constants, and functions with their signatures."""

from __future__ import annotations

import ast
import os
from pathlib import Path
from typing import Any

from .language import ARITHMETIC, MATH, PROVIDED, RESERVED, C, Kind, in_c, is_docstring, name_of

PACKAGE = "planar_pushing.core."
IMPORTS = {
    "__future__": {"annotations"}, "math": {*MATH}, "typing": {"NamedTuple"},
    PACKAGE + "_record": {"Record", "size_of"},
}  # fmt: skip
CONSTANT = (
    ast.Constant, ast.Name, ast.Load, ast.Tuple, ast.Call,
    ast.UnaryOp, ast.USub, ast.BinOp, ast.Pow, *ARITHMETIC,
)  # fmt: skip


class Names:
    """What the modules of a folder define, in any order."""

    def __init__(self, folder: Path) -> None:
        self.refusals: set[tuple[str, int, str]] = set()
        self.classes: dict[str, ast.ClassDef] = {}
        self.assignments: dict[str, ast.expr] = {}
        self.functions: dict[str, ast.FunctionDef] = {}
        self.constants: dict[str, Any] = {}
        self._defined: dict[str, str] = {}
        paths = sorted(folder.rglob("[!_]*.py"))
        self._modules = {
            PACKAGE + ".".join(path.relative_to(folder).with_suffix("").parts) for path in paths
        }
        for path in paths:
            tree = ast.parse(path.read_text(encoding="utf-8"), str(path))
            for node in ast.walk(tree):
                node.path = path  # type: ignore[attr-defined]
            for statement in tree.body:
                self._collect(statement, path)
        #: Offsets and kinds of the fields of each record, after those of its base, and its base.
        self.records: dict[str, dict[str, tuple[int, Kind]]] = {}
        self.bases: dict[str, str] = {}
        while ready := [*filter(self._is_ready, self.classes.values())]:
            for node in ready:
                self.bases[node.name] = ast.unparse(node.bases[0])
                self.records[node.name] = self._places(node)
        self.structs = {
            name: self._fields(node)
            for name, node in self.classes.items()
            if name not in self.records
        }
        self._order = self._sorted_structs()
        self._evaluate()
        self.signatures = {name: self._signature(node) for name, node in self.functions.items()}

    def refuse(self, node: ast.AST, reason: str) -> str:
        """Record a place outside the language, and return the unknown kind."""
        source: Any = node
        self.refusals.add((os.path.relpath(source.path), getattr(source, "lineno", 1), reason))
        return "?"

    def _collect(self, node: ast.stmt, path: Path) -> None:
        """Sort a statement of a module into imports, classes, constants and functions."""
        match node:
            case ast.Expr() if is_docstring(node):
                pass
            case ast.ImportFrom(module=str(module), names=names, level=0):
                allowed = IMPORTS.get(module, set())
                if path.stem == "numbers" and module == "typing":
                    allowed = allowed | {"Protocol", "overload"}
                for name in names:
                    if name.asname or not (module in self._modules or name.name in allowed):
                        self.refuse(node, f"import of {name.name} from {module}")
            case ast.ClassDef(name=name) | ast.FunctionDef(name=name):
                if path.stem != "numbers" or name not in PROVIDED:
                    table: Any = self.classes if isinstance(node, ast.ClassDef) else self.functions
                    self._define(table, name, node, node)
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                self._define(self.assignments, name, node, value)
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=value):
                for target, part in zip(
                    targets, self._parts(node, value, len(targets)), strict=True
                ):
                    self._define(self.assignments, ast.unparse(target), node, part)
            case _:
                self.refuse(node, f"{name_of(node)} in a module")

    def _parts(self, node: ast.stmt, value: ast.expr, count: int) -> list[ast.expr]:
        """The constants of several names: the elements of a tuple, or consecutive integers."""
        match value:
            case ast.Tuple(elts=parts) if len(parts) == count:
                return parts
            case ast.Call(func=ast.Name(id="range"), args=[*bounds], keywords=[]) if all(
                ast.unparse(bound).isdigit() for bound in bounds
            ):
                codes = range(*(int(ast.unparse(bound)) for bound in bounds))
                if len(codes) == count and len(bounds) < 3:
                    return [ast.Constant(code) for code in codes]
        self.refuse(node, f"{count} names for anything but {count} constants or a range of {count}")
        return [ast.Constant(0)] * count

    def _define(self, table: dict[str, Any], name: str, node: ast.stmt, value: ast.AST) -> None:
        """Record the definition of a name; the modules share one namespace."""
        if name in self._defined or name in RESERVED or name.endswith("_"):
            self.refuse(node, f"{name} is also defined {self._defined.get(name, 'by Python or C')}")
            return
        source: Any = node
        self._defined[name] = f"in {source.path.name}, line {node.lineno}"
        table[name] = value

    def _fields(self, node: ast.ClassDef) -> dict[str, Kind]:
        """The fields of a named tuple, and their kinds."""
        fields: dict[str, Kind] = {}
        if [*map(ast.unparse, (*node.bases, *node.keywords, *node.decorator_list))] != [
            "NamedTuple"
        ]:
            self.refuse(node, f"class {node.name} that is not just a NamedTuple")
            return fields
        for part in node.body:
            match part:
                case ast.AnnAssign(target=ast.Name(id=name), value=None):
                    kind = fields[name] = self.kind(part.annotation)
                    if kind == "None" or isinstance(kind, tuple):
                        self.refuse(part, f"field {name} of type {ast.unparse(part.annotation)}")
                case _ if not is_docstring(part):
                    self.refuse(part, f"{name_of(part)} in a NamedTuple")
        return fields

    def _is_ready(self, node: ast.ClassDef) -> bool:
        """Whether a class is a record whose base and fields are known, and is not known itself."""
        bases = [*map(ast.unparse, node.bases)]
        fields = {
            ast.unparse(part.annotation) for part in node.body if isinstance(part, ast.AnnAssign)
        }
        known = {"Record", *self.records}
        if node.name in known or len(bases) != 1 or bases[0] not in known:
            return False
        return not fields & {*self.classes} - known

    def _places(self, node: ast.ClassDef) -> dict[str, tuple[int, Kind]]:
        """Offsets and kinds of the fields of a record."""
        places = dict(self.records.get(self.bases[node.name], {}))
        for part in node.body:
            match part:
                case ast.AnnAssign(target=ast.Name(id=name), annotation=annotation, value=None):
                    kind = self.kind(annotation)
                    if kind not in ("?", "float", "int", "bool") and kind not in self.records:
                        self.refuse(part, f"field {name} of type {ast.unparse(annotation)}")
                    places[name] = self._size(places), kind
                case _ if not is_docstring(part):
                    self.refuse(part, f"{name_of(part)} in a record")
        return places

    def _size(self, places: dict[str, tuple[int, Kind]]) -> int:
        """The number of numbers of a record with these fields."""
        return sum(self.size_of(str(kind)) for _, kind in places.values())

    def size_of(self, kind: str) -> int:
        """The number of numbers of a record, 1 of another kind."""
        return self._size(self.records[kind]) if kind in self.records else 1

    def is_a(self, kind: Kind, other: Kind) -> bool:
        """Whether a value of a kind is one of another kind; a record is also a row of numbers."""
        while kind != other and kind in self.bases:
            kind = self.bases[str(kind)]
        return kind == other or (kind, other) in (
            ("Record", "Numbers"),
            ("Numbers", "Coefficients"),
        )

    def kind(self, node: ast.expr) -> Kind:
        """The kind that an annotation names."""
        match node:
            case ast.Constant(value=None):
                return "None"
            case ast.Name(id=name) if name in C or name in self.classes:
                return name
            case ast.Subscript(value=ast.Name(id="tuple"), slice=ast.Tuple(elts=members)):
                kinds = tuple(str(self.kind(member)) for member in members)
                if {*kinds} <= {"?", "float", "int", "bool", *self.classes}:
                    return kinds
        return self.refuse(node, f"type {ast.unparse(node)}")

    def _signature(self, node: ast.FunctionDef) -> tuple[list[Kind], Kind]:
        """The kinds of a function's arguments and of its result."""
        some = node.args
        if some.posonlyargs or some.kwonlyargs or some.vararg or some.kwarg or some.defaults:
            self.refuse(node, f"arguments of {node.name} that are not just names and types")
        if node.decorator_list or getattr(node, "type_params", None):
            self.refuse(node, f"decorators or type parameters of {node.name}")
        kinds: list[Kind] = []
        for argument in some.args:
            kind = self.kind(argument.annotation) if argument.annotation else "None"
            if kind == "None":
                kind = self.refuse(argument, f"argument {argument.arg} without a type")
            kinds.append(kind)
        if node.returns is None:
            return kinds, self.refuse(node, f"no type of the result of {node.name}")
        return kinds, self.kind(node.returns)

    def _evaluate(self) -> None:
        """Compute the constants, each after those that it needs."""
        rest = dict(self.assignments)
        while rest:
            known = len(self.constants)
            for name, node in list(rest.items()):
                try:
                    self.constants[name] = self.evaluate(node)
                except NameError:
                    continue
                except (ArithmeticError, TypeError, ValueError) as error:
                    self.constants[name] = self.refuse(node, f"constant {name}: {error}")
                del rest[name]
            if known == len(self.constants):
                for name, node in rest.items():
                    self.constants[name] = self.refuse(node, f"constant {name}: unknown names")
                return

    def evaluate(self, node: ast.expr) -> Any:
        """The value of a constant: an integer, a float, or a tuple of floats."""
        nodes = [*ast.walk(node)]
        calls = {ast.unparse(part.func) for part in nodes if isinstance(part, ast.Call)}
        allowed: dict[str, Any] = {"float": float, "len": len, "size_of": self.size_of}
        if not all(isinstance(part, CONSTANT) for part in nodes) or not calls <= {*allowed}:
            raise ValueError(f"{ast.unparse(node)} is not arithmetic")
        allowed |= {"__builtins__": {}} | {name: name for name in self.records}
        code = compile(ast.fix_missing_locations(ast.Expression(node)), "constant", "eval")
        value = eval(code, allowed, self.constants)
        kinds = [*map(type, value if isinstance(value, tuple) else [value])]
        if {*kinds} != {float} and kinds != [int]:
            raise ValueError("only an integer, a float, or a tuple of floats is allowed")
        return value

    def _sorted_structs(self) -> list[str]:
        """The named tuples, each after those in its fields."""
        order: list[str] = []
        rest = {name: {*map(str, fields.values())} for name, fields in self.structs.items()}
        while rest:
            ready = [name for name, kinds in rest.items() if not rest.keys() & kinds]
            if not ready:
                name = min(rest)
                self.refuse(self.classes[name], f"class {name} that contains itself")
                break
            order += ready
            rest = {name: kinds for name, kinds in rest.items() if name not in ready}
        return order

    def structs_in_c(self) -> list[str]:
        """Declarations of the records, which are addresses of numbers, and of the named tuples."""
        lines = [f"ctypedef double* {name}" for name in self.records]
        for name in self._order:
            lines.append(f"cdef struct {name}:")
            # A field has a different name in C, because headers define macros such as `linux`.
            for field, kind in self.structs[name].items():
                lines.append(f'    {in_c(kind)} {field} "{field}_"')
        return lines

    def constants_in_c(self) -> list[str]:
        """Declarations of the floats as variables, so that the C compiler does not compute with them."""
        lines = []
        for name, value in self.constants.items():
            if isinstance(value, tuple):
                lines.append(f"cdef double {name}[{len(value)}]\n{name}[:] = {list(value)!r}")
            elif isinstance(value, float):
                lines.append(f"cdef double {name} = float('{value!r}')")
        return lines
