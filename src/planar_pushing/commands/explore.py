"""The command `explore`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from planar_pushing.commands.words import Commands, command
from planar_pushing.terms.errors import require_number


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    about = "Open a scene in the browser, where you drag the push, rod, support and force."
    sub = command(commands, "explore", serve_page, about, "scene.yaml")
    sub.add_argument(
        "scene", type=Path, nargs="?", metavar="SCENE.yaml",
        help="scene file to start from (default: pulling, Fig. 3)",
    )  # fmt: skip
    sub.add_argument(
        "--port", type=int, default=0, metavar="NUMBER",
        help="port of 127.0.0.1 that serves the page, a whole number up to 65535 (default: a free port)",
    )  # fmt: skip
    sub.add_argument(
        "--no-browser", action="store_true", help="print the address without opening a browser"
    )


def serve_page(args: argparse.Namespace) -> dict[str, Any]:
    """Serve the page until it is closed."""
    # The server, which refuses a port that is not free, takes seconds to import.
    allowed, remedy = "a whole number up to 65535", "leave it out to use a free port"
    require_number("port", args.port, lambda port: 0 <= port <= 65535, allowed, remedy)
    from planar_pushing.scenes.contacts_files import load_any_file

    file: Any = None
    if args.scene is not None:
        file = load_any_file(args.scene)
        file.build()
    from planar_pushing.explorer.server import Explorer

    explorer = Explorer(file, args.port)
    print(f"{explorer.url} shows the explorer; press its Close button or Ctrl-C to end", flush=True)
    explorer.run(not args.no_browser)
    return {"closed": explorer.url}
