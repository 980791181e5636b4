"""JSON schemas of scene and study files, generated from their models: `make schemas`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from planar_pushing.scenes.object_model import ObjectFile
from planar_pushing.scenes.scene_model import SceneFile
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.study.model import StudyFile

#: A scene file is either in the body frame or in the frame of an object.
SCHEMAS: dict[str, TypeAdapter[Any]] = {
    "scene": TypeAdapter(SceneFile | ObjectFile),
    "study": TypeAdapter(StudyFile),
}


def schema_text(name: str) -> str:
    """JSON schema of a scene or a study file, as text."""
    return json.dumps(SCHEMAS[name].json_schema(mode="validation"), indent=2) + "\n"


def main(folder: str = "workflow/schemas") -> None:
    """Write the schemas."""
    for name in SCHEMAS:
        path = Path(folder) / f"{name}.schema.json"
        with replacing(path) as temporary:
            temporary.write_text(schema_text(name), encoding="utf-8")
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
