"""Field types of scene and study files; each states its allowed values, for errors and the schema."""

from __future__ import annotations

import itertools
import math
import re
from enum import StrEnum
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    WithJsonSchema,
    model_validator,
)
from pydantic_core import PydanticCustomError

from planar_pushing.mechanics.contact import FRICTION_COEFFICIENT, ContactMode
from planar_pushing.mechanics.slider import ROD_ANGLE
from planar_pushing.terms.declared import NUMBER, Within, finite, nonnegative, positive
from planar_pushing.terms.errors import InvalidValue, suggestion
from planar_pushing.terms.options import (
    EffectSet,
    Event,
    Method,
    Policy,
    PusherFrame,
    Shape,
)


def refuse(allowed: str) -> PydanticCustomError:
    """Error for a value that is not as `allowed` describes."""
    return PydanticCustomError("not_allowed", "{allowed}", {"allowed": allowed})


def refuse_key(name: str, value: object, allowed: str, remedy: str) -> PydanticCustomError:
    """Error for a key of a section whose value is not as `allowed` describes."""
    context = {"name": name, "given": value, "allowed": allowed, "remedy": remedy}
    return PydanticCustomError("refused", "{allowed}", context)


class FileModel(BaseModel):
    """Section of a file; it is frozen and rejects unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, ser_json_inf_nan="constants")

    @model_validator(mode="before")
    @classmethod
    def _require_known_keys(cls, value: object) -> object:
        return require_known_keys(value, list(cls.model_fields))


def require_known_keys(value: object, known: list[str]) -> object:
    """Refuse anything but a mapping with some of these keys."""
    if not isinstance(value, dict):
        raise refuse(f"a mapping with the keys {', '.join(known)}")
    for key in value:
        if key not in known:
            raise PydanticCustomError("unknown_key", "unknown key", {"key": key, "known": known})
    return value


def _not_empty(value: object) -> object:
    if not isinstance(value, (list, tuple)) or not value:
        raise refuse("a list with at least one entry")
    return value


#: Requires a list that is not empty.
NotEmpty = BeforeValidator(_not_empty)


def _name(value: object) -> object:
    if not isinstance(value, str) or not re.fullmatch(r"[A-Za-z0-9_]+", value):
        raise refuse("a name of letters, digits and underscores, which becomes a file's name")
    return value


#: A name that becomes part of file names.
Name = Annotated[str, BeforeValidator(_name)]


def _file_path(value: object) -> object:
    if not isinstance(value, str) or not value.isprintable() or set(value) & {"{", "}"}:
        raise refuse("a path without braces, which the workflow reads as wildcards")
    return value


def _printable(value: str) -> str:
    if not value.isprintable():
        raise refuse("text without control characters")
    return value


#: A line of text.
Text = Annotated[str, AfterValidator(_printable)]


def _truth(value: object) -> object:
    if not isinstance(value, bool):
        raise refuse("true or false")
    return value


#: A boolean, not a word such as "yes".
Truth = Annotated[bool, BeforeValidator(_truth)]

#: Path of a file or a folder in a study, relative to the study file.
FilePath = Annotated[str, BeforeValidator(_file_path)]


def choice(options: type[StrEnum]) -> Any:
    """Type of a text that must be one of these options."""
    return choice_of_names(tuple(map(str, options)))


def choice_of_names(names: tuple[str, ...]) -> Any:
    """Type of a text that must be one of these names; the error for an unknown name suggests one."""
    quoted = list(map(repr, names))
    allowed = f"{', '.join(quoted[:-1])} or {quoted[-1]}"

    def require_known(value: object) -> object:
        if value not in names:
            raise refuse_key("", value, allowed, suggestion(value, names, CHANGE))
        return value

    return Annotated[Literal.__getitem__(names), BeforeValidator(require_known)]


#: Maximum number of values on an axis.
MOST = 10**5
AXIS = (
    "a list of increasing numbers, or {start, stop, step} with a step > 0 that divides the range, "
    "or a list that holds such ranges"
)


def _expand(value: object) -> object:
    if isinstance(value, dict):
        value = _range(value)
    elif isinstance(value, (list, tuple)) and any(isinstance(entry, dict) for entry in value):
        parts = [_range(entry) if isinstance(entry, dict) else [entry] for entry in value]
        value = sorted({_axis_number(entry) for part in parts for entry in part})
    if not isinstance(value, (list, tuple)):
        raise refuse(AXIS)
    if not value:
        raise refuse(f"{AXIS}, and at least one number")
    return tuple(value)


def _range(value: dict[object, object]) -> list[float]:
    keys = ("start", "stop", "step")
    if set(value) != set(keys):
        raise refuse(AXIS)
    return _steps(*(_axis_number(value[key]) for key in keys))


def _axis_number(value: object) -> float:
    try:
        return NOT_NAN.read(value)
    except InvalidValue:
        raise refuse(AXIS) from None


def _increasing(values: tuple[float, ...]) -> tuple[float, ...]:
    if any(b <= a for a, b in itertools.pairwise(values)):
        raise refuse(AXIS)
    return values


def _steps(start: float, stop: float, step: float) -> list[float]:
    """Values from `start` to `stop`, including both, without accumulated rounding errors."""
    if step <= 0 or stop < start:
        return []
    if (stop - start) / step > MOST:
        raise refuse(f"{AXIS}, into at most {MOST} steps")
    count = round((stop - start) / step)
    if abs(count * step - (stop - start)) > 1e-9 * step:
        return []
    return [round(start + i * (stop - start) / max(count, 1), 12) for i in range(count + 1)]


def axis(item: Any) -> Any:
    """Type of a grid axis: a range, or a list of ranges and numbers of type `item`."""
    numbers = {"description": item.__metadata__[0].words} | dict(item.__metadata__[0].schema)
    span = {"type": "object", "additionalProperties": False, "required": ["start", "stop", "step"]}
    span["properties"] = {
        "start": numbers,
        "stop": numbers,
        "step": {"type": "number", "exclusiveMinimum": 0},
    }
    items = {"anyOf": [numbers, span]}
    schema = {"anyOf": [{"type": "array", "minItems": 1, "items": items}, span]}
    return Annotated[
        tuple[item, ...],
        BeforeValidator(_expand),
        AfterValidator(_increasing),
        WithJsonSchema(schema | {"description": AXIS}),
    ]


#: A remedy that says no more than that the value is wrong.
CHANGE = "change the value"
POSITIVE, NONNEGATIVE, FINITE = positive(CHANGE), nonnegative(CHANGE), finite(CHANGE)
Positive = Annotated[float, POSITIVE]
NonNegative = Annotated[float, NONNEGATIVE]
FiniteNumber = Annotated[float, FINITE]
RodAngle = Annotated[float, ROD_ANGLE.degrees]
Degrees = Annotated[float, finite(CHANGE, "a finite number of degrees")]
NOT_NAN = Within(lambda x: not math.isnan(x), "a number, or inf", CHANGE)
Number = Annotated[float, NOT_NAN]
Share = Annotated[
    float,
    Within(
        lambda x: 0 <= x <= 1, "a number in [0, 1]", CHANGE, NUMBER | {"minimum": 0, "maximum": 1}
    ),
]
FrictionCoefficient = Annotated[
    float,
    Within(
        lambda x: x >= 0, "a number >= 0, or inf", CHANGE,
        {"anyOf": [NUMBER | {"minimum": 0}, {"const": "inf"}]},
    ),
]  # fmt: skip
FiniteFrictionCoefficient = Annotated[float, FRICTION_COEFFICIENT]
Count = Annotated[
    int,
    Within(
        lambda x: 1 <= x < math.inf and x == int(x), "an integer >= 1", CHANGE,
        {"type": "integer", "minimum": 1},
    ),
    AfterValidator(int),
]  # fmt: skip

PolicyName: Any = choice(Policy)
MethodName: Any = choice(Method)
ShapeName: Any = choice(Shape)
FrameName: Any = choice(PusherFrame)
EventName = choice_of_names(tuple(event.name for event in Event if event is not Event.NONE))
ModeName = choice_of_names(tuple(mode.name for mode in ContactMode))
EffectsName: Any = choice(EffectSet)

Coordinates: Any = axis(FiniteNumber)
Lengths: Any = axis(NonNegative)
Magnitudes: Any = axis(Positive)
RodAngles: Any = axis(RodAngle)
Angles: Any = axis(Degrees)
Shares: Any = axis(Share)
FrictionCoefficients: Any = axis(FrictionCoefficient)
FiniteFrictionCoefficients: Any = axis(FiniteFrictionCoefficient)
