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
profile.write_text('c.InlineBackend.figure_formats = {"svg"}\n', encoding="utf-8")

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
    "results_in_text",
]
source_suffix = {".md": "myst-nb"}
exclude_patterns = ["examples/**"]
#: The results of the pipeline, relative to this folder.
results_folder = "../../results"

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
