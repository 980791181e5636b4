"""JSON schemas of scene files and of studies of both kinds, generated from their models: `make schemas`."""

from __future__ import annotations

import json
from pathlib import Path

from planar_pushing.study.files.fields import FileModel
from planar_pushing.study.files.models import StudyFile
from planar_pushing.study.files.scene_model import SceneFile
from planar_pushing.study.files.sliders_model import SlidersFile

SCHEMAS: dict[str, type[FileModel]] = {
    "scene": SceneFile,
    "study": StudyFile,
    "sliders": SlidersFile,
}


def schema_text(name: str) -> str:
    """JSON schema of the "scene", "study" or "sliders" file, as text."""
    return json.dumps(SCHEMAS[name].model_json_schema(mode="validation"), indent=2) + "\n"


def main(folder: str = "workflow/schemas") -> None:
    """Write the schemas."""
    for name in SCHEMAS:
        path = Path(folder) / f"{name}.schema.json"
        path.write_text(schema_text(name), encoding="utf-8")
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
