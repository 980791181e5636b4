"""Sphinx configuration of the manual, which is built offline from this folder and the docstrings."""

import atexit
import os
import shutil
import sys
import tempfile
from pathlib import Path

from planar_pushing import __version__
from planar_pushing.drawing.canvas.colors import MOTION
from planar_pushing.drawing.canvas.style import STYLE_SHEET

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "extensions"))

# Kernels run this Python, communicate over loopback, and write to a folder that is removed after the build.
KERNELS = tempfile.mkdtemp(prefix="kernels_")
atexit.register(shutil.rmtree, KERNELS, ignore_errors=True)
for folder in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"):
    os.environ[folder] = KERNELS
os.environ.pop("JUPYTER_PATH", None)
# Their plots use the style of the figures and are vector graphics that are identical in every build.
os.environ["MATPLOTLIBRC"] = str(STYLE_SHEET)
profile = Path(KERNELS, "profile_default", "ipython_kernel_config.py")
profile.parent.mkdir()
# They start in a folder of their own, which holds the results.
results_folder = "../../results"  # relative to this folder
START = Path(KERNELS, "start")
START.mkdir()
(START / "results").symlink_to((HERE / results_folder).resolve())
settings = {
    "InlineBackend.figure_formats": {"svg"},
    "IPKernelApp.exec_lines": [f"__import__('os').chdir({str(START)!r})"],
}
profile.write_text(
    "".join(f"c.{key} = {value!r}\n" for key, value in settings.items()), encoding="utf-8"
)

project = "planar-pushing"
author = "The planar-pushing developers"
version = release = __version__

extensions = [
    "sphinx.ext.autodoc",
    "numpydoc",
    "myst_nb",
    "sphinx-mathjax-offline",
    "command_reference",
    "docstrings",
    "figure_gallery",
    "ledger_proofs",
    "results_in_text",
]
source_suffix = {".md": "myst-nb"}
exclude_patterns = ["examples/**"]

nitpicky = True
# Parameters, and names from other packages, have no page here.
nitpick_ignore_regex = [("py:.*", r"(?!planar_pushing).*")]
default_role = "py:obj"
smartquotes = False  # would turn the hyphens of command-line options into dashes
autodoc_typehints = "none"  # the docstrings describe the types in words
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
add_module_names = False
toc_object_entries_show_parents = "hide"

myst_enable_extensions = ["amsmath", "attrs_inline", "deflist", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_timeout = 300
nb_execution_raise_on_error = True
nb_merge_streams = True

html_theme = "furo"
html_title = "planar-pushing"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_copyright = False
#: The color of motions, and the same hue for dark pages.
LINKS = {"light": MOTION, "dark": "#56B4E9"}
BRAND = ("color-brand-primary", "color-brand-content", "color-brand-visited", "color-api-name")
html_theme_options = {
    f"{page}_css_variables": dict.fromkeys(BRAND, color) for page, color in LINKS.items()
}
#: What a page with cells begins with, so that they run; the page itself is plain Markdown.
NOTEBOOK = "---\nfile_format: mystnb\nkernelspec:\n  name: python3\n---\n\n"


def mark_notebook(app, page, text):
    """Put what makes a page a notebook before its text."""
    if "```{code-cell}" in text[0]:
        text[0] = NOTEBOOK + text[0]


def setup(app):
    """Register the event."""
    app.connect("source-read", mark_notebook)
