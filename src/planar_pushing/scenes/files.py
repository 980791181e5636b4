"""Read and write scene and study files; report errors in a file in clear one-line messages."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError
from pydantic_core import ErrorDetails
from ruamel.yaml import YAML

from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.entries import TAGS, scene_entry
from planar_pushing.mechanics.scene import Scene, require_scene, require_single
from planar_pushing.mechanics.supports import SHAPES, Composite
from planar_pushing.objects.plausible import warn_of_doubts
from planar_pushing.scenes.fields import FileModel
from planar_pushing.scenes.object_model import ObjectFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.scenes.yaml_text import format_entry, read_yaml
from planar_pushing.terms.errors import InvalidFile, InvalidValue, require_path, suggestion
from planar_pushing.terms.replacing import PathLike, replacing

Model = TypeVar("Model", bound=FileModel)

#: Keys that identify the kind of file.
KINDS = {
    "contact": "a scene file", "contacts": "a scene file with several contacts", "grid": "a study file",
}  # fmt: skip


def load_scene(path: PathLike) -> Scene:
    """Read a scene file.

    Warns
    -----
    SceneWarning
        If the scene is doubtful, as in `scene_at`.

    Raises
    ------
    InvalidFile
        If the file is invalid; the message names the file, key, value, allowed values and remedy.
    """
    return load_scene_file(path).build()


def load_scene_file(path: PathLike) -> SceneFile:
    """Read a scene file or an object file as a scene file; errors and warnings as in `load_scene`."""
    content = read_yaml(Path(require_path("path", path)))
    if isinstance(content, dict) and "contacts" in content and "contact" not in content:
        raise InvalidFile(
            f"{path}: contacts: {format_entry(content['contacts'])} given; allowed: contact, of one "
            "pusher; for several contacts use load_contacts, or planar-pushing solve, simulate or draw"
        )
    if isinstance(content, dict) and "object" in content and "contacts" not in content:
        entry = load_model(path, ObjectFile)
        try:
            file = entry.scene_file()
        except (
            ValidationError
        ) as error:  # far from its origin, an object is lost in rounding errors
            raise _refusal(Path(path), error) from None
    else:
        file = load_model(path, SceneFile)
    scene = file.build()
    warn_of_doubts(scene.effects, scene.contact, scene.slider.outline_in_body())
    return file


def has_contacts(path: PathLike) -> bool:
    """Whether a file is that of a scene with several contacts; errors as in `load_scene`."""
    content = read_yaml(Path(require_path("path", path)))
    return isinstance(content, dict) and "contacts" in content


def save_scene(scene: Scene, path: PathLike, title: str = "") -> None:
    """Write a scene file that `load_scene` reads back as the same scene.

    The rod angle is stored in degrees and can therefore change by one unit in the last place.

    Raises
    ------
    InvalidValue
        If the scene has a law, an effect or a support that scene files cannot represent.
    """
    require_title(title)
    require_in_files(require_single(require_scene(scene)).effects)
    entry = scene_entry(scene, title)
    save_scene_file(SceneFile.model_validate(entry), require_path("path", path))


def require_title(title: object) -> None:
    """Refuse a title that is no text."""
    if not isinstance(title, str):
        raise InvalidValue("title", title, "text", "name the scene")


def require_in_files(effects: Iterable[Effect]) -> None:
    """Refuse effects whose support scene files cannot describe."""
    for effect in effects:
        support = getattr(effect, "support", None)
        if support is not None and not _is_in_files(support):
            raise InvalidValue(
                "support", support, f"the shapes of scene files: {', '.join(SHAPES)}",
                "describe it by these shapes, for instance as a Composite of them",
            )  # fmt: skip


def _is_in_files(support: Any) -> bool:
    """Whether a scene file can describe a support: all but those of a class of the user's own."""
    members = support.members if type(support) is Composite else ()
    return type(support) in TAGS and all(_is_in_files(member) for _, member in members)


def save_scene_file(file: SceneFile, path: PathLike) -> None:
    """Write a scene file, including its simulation, that `load_scene_file` reads back unchanged."""
    write_plain(file.model_dump(mode="json", exclude_none=True), path)


def save_object_file(content: dict[str, Any], path: PathLike) -> None:
    """Write the content of an object file unchanged; `load_scene` can read the file.

    Raises
    ------
    InvalidFile
        If the content is not a valid scene or the file cannot be written.
    """
    try:
        ObjectFile.model_validate(content)
    except ValidationError as error:
        raise InvalidFile(explain(Path(path), error.errors()[0])) from None
    write_plain(content, path)


def write_plain(content: dict[str, Any], path: PathLike) -> None:
    """Write plain values as YAML, with each vector on one line."""
    with replacing(path) as temporary, temporary.open("w", encoding="utf-8") as stream:
        writer = YAML(typ="safe", pure=True)
        writer.sort_base_mapping_type_on_output = False  # type: ignore[assignment]
        writer.default_flow_style = None
        writer.dump(content, stream)


def load_model(path: PathLike, model: type[Model]) -> Model:
    """Read a YAML file as a model of its content; errors as in `load_scene`."""
    path = Path(require_path("path", path))
    content = read_yaml(path)
    if not isinstance(content, dict):
        keys = ", ".join(model.model_fields)
        raise InvalidFile(f"{path}: holds no keys; allowed: {keys}; write them as key: value")
    try:
        return model.model_validate(content)
    except ValidationError as error:
        raise _refusal(path, error) from None


def _refusal(path: Path, error: ValidationError) -> InvalidFile:
    """The errors of a file, one a line, of which the first five are told."""
    lines = [explain(path, detail) for detail in error.errors()]
    more = [f"{path}: and {len(lines) - 5} more"] if len(lines) > 5 else []
    return InvalidFile("\n".join(lines[:5] + more))


def _key(location: tuple[int | str, ...]) -> str:
    """Location as written in the file, without the tags that distinguish laws, effects and policies."""
    key, previous = "", None
    for index, part in enumerate(location):
        tag = previous in ("support", "on_ambiguity")
        tag |= previous == "contact" and location[0] != "object"
        tag |= index > 1 and location[index - 2] in ("effects", "supports", "contacts")
        if isinstance(part, int):
            key += f"[{part}]"
        elif not tag:
            word = format_entry(part)[1:].removesuffix("'")
            key += f".{word}" if key else word
        previous = part
    return key


def _other_kind(content: dict[object, object], known: list[str]) -> str:
    """Remedy for unknown top-level keys: another file if this one is of another kind."""
    kinds = [kind for key, kind in KINDS.items() if key in content and key not in known]
    return f"this is {kinds[0]}; give a file with these keys" if kinds else "remove the key"


def _quoted_words(text: str) -> list[str]:
    """The names between quotation marks in a message of pydantic."""
    return re.findall(r"'([^']*)'", text)


def explain(path: Path, error: ErrorDetails) -> str:
    """One-line message with the file, key, value, allowed values and remedy."""
    key, value, context = _key(error["loc"]), error["input"], error.get("ctx", {})
    allowed, remedy = error["msg"], "change the value"
    match error["type"]:
        case "missing":
            return f"{path}: {key}: missing; allowed: a value for this key; add it"
        case "unknown_key":
            unknown, known = context["key"], context["known"]
            remedy = "remove the key" if key else _other_kind(value, known)
            remedy = suggestion(unknown, known, remedy)
            word = (
                format_entry(unknown)[1:].removesuffix("'") if isinstance(unknown, str) else unknown
            )
            key, value = (f"{key}.{word}" if key else str(word)), value[unknown]
            allowed = f"the keys {', '.join(known)}"
        case "refused":
            name, remedy = context["name"], context["remedy"]
            key = f"{key}.{name}" if key and name[:1] not in ("", "[") else f"{key}{name}"
            value = context["given"] if name else value
        case "union_tag_invalid":
            tag, words = context["discriminator"][1:-1], context["expected_tags"]
            key, value, allowed = f"{key}.{tag}", context["tag"], words
            remedy = suggestion(value, _quoted_words(words), remedy)
        case "union_tag_not_found":
            allowed = f"a mapping with the key {context['discriminator']}"
        case "literal_error":
            allowed = context["expected"]
            remedy = suggestion(value, _quoted_words(allowed), remedy)
        case "model_attributes_type" | "dict_type":
            allowed = "a mapping"
        case "string_type":
            allowed = "text"
    return f"{path}: {key or 'the file'}: {format_entry(value)} given; allowed: {allowed}; {remedy}"
