"""Sphinx configuration. Warnings are errors; every code cell is run at build time."""

import sys
from pathlib import Path

from wraparc.version import __version__

sys.path.insert(0, str(Path(__file__).parent / "building"))

project = "wraparc"
author = "wraparc developers"
project_copyright = author
version = release = __version__

extensions = [
    "equations",
    "kernels",
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
]
exclude_patterns = ["_build", "building"]
html_math_renderer = "katex"
html_static_path = ["_static"]
html_css_files = ["start.css"]
nitpicky = True
# The classes of other libraries are not documented here, nor those inside the solver.
nitpick_ignore_regex = [
    ("py:.*", r"(?!wraparc).*"),
    ("py:.*", r"wraparc\.(arc\.(quantities|summary)|drive\.pull|conveyor\.description)\..*"),
]

myst_enable_extensions = ["amsmath", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

# "force", not "cache": a page must fail when the library changes under it.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 180
nb_merge_streams = True
nb_render_markdown_format = "gfm"  # tables made by a cell

autodoc_default_options = {"members": True, "show-inheritance": True}
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented_params"
autodoc_typehints_format = "short"
autodoc_class_signature = "mixed"
napoleon_google_docstring = False
napoleon_use_rtype = False

html_theme = "pydata_sphinx_theme"
html_title = "wraparc"
html_show_sourcelink = False
html_theme_options = {
    "navigation_with_keys": False,
    "show_prev_next": False,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
}
