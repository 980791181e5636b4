"""Field types of scene and study files; each states its allowed values, for errors and the schema."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable
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

from planar_pushing.mechanics.contact import ContactMode
from planar_pushing.terms.domain import SIDE
from planar_pushing.terms.options import (
    SAMPLES,
    TOLERANCE,
    AtZeroNormal,
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


class FileModel(BaseModel):
    """Section of a file; it is frozen and rejects unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, given: object) -> object:
        if not isinstance(given, dict):
            raise refuse(f"a mapping with the keys {', '.join(cls.model_fields)}")
        for key in given:
            if key not in cls.model_fields:
                context = {"key": key, "known": list(cls.model_fields)}
                raise PydanticCustomError("unknown_key", "unknown key", context)
        return given


def _not_empty(given: object) -> object:
    if not isinstance(given, (list, tuple)) or not given:
        raise refuse("a list with at least one entry")
    return given


#: Requires a list that is not empty.
NotEmpty = BeforeValidator(_not_empty)


def _name(given: object) -> object:
    if not isinstance(given, str) or not re.fullmatch(r"[A-Za-z0-9_]+", given):
        raise refuse("a name of letters, digits and underscores, which becomes a file's name")
    return given


#: A name that becomes part of file names.
Name = Annotated[str, BeforeValidator(_name)]


def _file_path(given: object) -> object:
    if not isinstance(given, str) or not given.isprintable() or set(given) & {"{", "}"}:
        raise refuse("a path without braces, which the workflow reads as wildcards")
    return given


def _printable(given: str) -> str:
    if not given.isprintable():
        raise refuse("text without control characters")
    return given


#: A line of text.
Text = Annotated[str, AfterValidator(_printable)]


def _truth(given: object) -> object:
    if not isinstance(given, bool):
        raise refuse("true or false")
    return given


#: A boolean, not a word such as "yes".
Truth = Annotated[bool, BeforeValidator(_truth)]

#: Path of a file or a folder in a study, relative to the study file.
FilePath = Annotated[str, BeforeValidator(_file_path)]


def _number(given: object, allows: Callable[[float], bool], allowed: str) -> float:
    number = math.inf if given == "inf" else given
    if isinstance(number, bool) or not isinstance(number, (int, float)):
        raise refuse(allowed)
    try:
        value = float(number)
    except OverflowError:
        raise refuse(allowed) from None
    if not allows(value):
        raise refuse(allowed)
    return value


def number(allowed: str, allows: Callable[[float], bool], **schema: Any) -> Any:
    """Type of a number that satisfies `allows`, described by `allowed`."""
    return Annotated[
        float,
        BeforeValidator(lambda given: _number(given, allows, allowed)),
        WithJsonSchema({"description": allowed} | (schema or {"type": "number"})),
    ]


def choice(options: type[StrEnum]) -> Any:
    """Type of a text that must be one of these options."""
    return Literal.__getitem__(tuple(map(str, options)))


#: Corners of a regular polygon.
CornerCount: Any = number(
    "a whole number >= 3", lambda x: x >= 3 and x == int(x), type="integer", minimum=3
)
#: Counting numbers.
COUNT = "an integer >= 1"


def _counts(given: float) -> bool:
    return 1 <= given < math.inf and given == int(given)


def spelled(options: type[StrEnum]) -> Any:
    """As `choice`, but the error for an unknown option suggests a similar one."""
    return named(tuple(map(str, options)))


def named(names: tuple[str, ...]) -> Any:
    """Type of a text that must be one of these names; the error for an unknown name suggests one."""
    context = {"allowed": " or ".join(map(repr, names)), "names": names}

    def known(given: object) -> object:
        if given not in names:
            raise PydanticCustomError("unknown_option", "{allowed}", context)
        return given

    return Annotated[Literal.__getitem__(names), BeforeValidator(known)]


def _side(given: object) -> object:
    ends = [_number_of(each) for each in given] if isinstance(given, (list, tuple)) else []
    if len(ends) != 2 or not ends[0] < 0 < ends[1]:
        raise refuse(f"{SIDE[0]}; {SIDE[1]}")
    return tuple(ends)


def _number_of(given: object) -> float:
    """Convert to a number; JSON stores infinity as text. NaN if it is not a number."""
    number = (
        {"inf": math.inf, "-inf": -math.inf}.get(given, given) if isinstance(given, str) else given
    )
    plain = isinstance(number, (int, float)) and not isinstance(number, bool)
    return float(number) if plain else math.nan  # type: ignore[arg-type]


END = {"anyOf": [{"type": "number"}, {"enum": ["inf", "-inf"]}]}
#: Ends of a side, measured along it from the contact.
Side = Annotated[
    tuple[float, float],
    BeforeValidator(_side),
    WithJsonSchema(
        {"description": SIDE[0], "type": "array", "minItems": 2, "maxItems": 2, "items": END}
    ),
]

#: Maximum number of values on an axis.
MOST = 10**5
AXIS = (
    "a list of increasing numbers, or {start, stop, step} with a step > 0 that divides the range, "
    "or a list that holds such ranges"
)


def _expand(given: object) -> object:
    if isinstance(given, dict):
        given = _range(given)
    elif isinstance(given, (list, tuple)) and any(isinstance(each, dict) for each in given):
        parts = [_range(each) if isinstance(each, dict) else [each] for each in given]
        numbers = [
            _number(each, lambda x: not math.isnan(x), AXIS) for part in parts for each in part
        ]
        given = sorted(set(numbers))
    if not isinstance(given, (list, tuple)):
        raise refuse(AXIS)
    if not given:
        raise refuse(f"{AXIS}, and at least one number")
    return tuple(given)


def _range(given: dict[object, object]) -> list[float]:
    keys = ("start", "stop", "step")
    if set(given) != set(keys):
        raise refuse(AXIS)
    return _steps(*(_number(given[key], math.isfinite, AXIS) for key in keys))


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
    numbers = item.__metadata__[-1].json_schema
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


Positive: Any = number(
    "a finite number > 0", lambda x: 0 < x < math.inf, type="number", exclusiveMinimum=0
)
NonNegative: Any = number(
    "a finite number >= 0", lambda x: 0 <= x < math.inf, type="number", minimum=0
)
RodAngle: Any = number(
    "degrees in the open interval (0, 180)", lambda x: 0 < x < 180,
    type="number", exclusiveMinimum=0, exclusiveMaximum=180,
)  # fmt: skip
Degrees: Any = number("a finite number of degrees", math.isfinite)
FiniteNumber: Any = number("a finite number", math.isfinite)
RelativeTolerance: Any = number(
    TOLERANCE.allowed, TOLERANCE.holds,
    type="number", minimum=TOLERANCE.least, maximum=TOLERANCE.most,
)  # fmt: skip
SampleCount: Any = number(
    SAMPLES.allowed, lambda n: SAMPLES.holds(n) and n == int(n),
    type="integer", minimum=SAMPLES.least, maximum=int(SAMPLES.most),
)  # fmt: skip
Number: Any = number("a number, or inf", lambda x: not math.isnan(x))
Share: Any = number(
    "a number in [0, 1]", lambda x: 0 <= x <= 1, type="number", minimum=0, maximum=1
)
FrictionCoefficient: Any = number(
    "a number >= 0, or inf", lambda x: x >= 0,
    anyOf=[{"type": "number", "minimum": 0}, {"const": "inf"}],
)  # fmt: skip
FiniteFrictionCoefficient: Any = number(
    "a finite number >= 0; infinite friction is a separate law, law: infinite_friction",
    lambda x: 0 <= x < math.inf, type="number", minimum=0,
)  # fmt: skip

Count = Annotated[
    int,
    BeforeValidator(lambda given: int(_number(given, _counts, COUNT))),
    WithJsonSchema({"type": "integer", "minimum": 1, "description": COUNT}),
]

PolicyName: Any = choice(Policy)
MethodName: Any = choice(Method)
ShapeName: Any = spelled(Shape)
FrameName: Any = spelled(PusherFrame)
EventName = named(tuple(event.name for event in Event if event is not Event.NONE))
ModeName = named(tuple(mode.name for mode in ContactMode))
AtZeroNormalName: Any = choice(AtZeroNormal)
EffectsName: Any = choice(EffectSet)

Coordinates: Any = axis(FiniteNumber)
Lengths: Any = axis(NonNegative)
Magnitudes: Any = axis(Positive)
RodAngles: Any = axis(RodAngle)
Angles: Any = axis(Degrees)
Shares: Any = axis(Share)
FrictionCoefficients: Any = axis(FrictionCoefficient)
FiniteFrictionCoefficients: Any = axis(FiniteFrictionCoefficient)
