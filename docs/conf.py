"""Sphinx configuration; `make docs` builds the pages."""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "src"), str(ROOT / "docs" / "extensions")]

import springback  # noqa: E402

project = "springback"
author = "The springback developers"
project_copyright = f"2026, {author}"
version = release = springback.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",  # a page for each module
    "sphinx.ext.napoleon",
    "mathml",  # these and the next are in docs/extensions
    "docstrings",
    "named_in_code",
    "settings_tables",
    "modules",
    "presets",
    "measure_tables",
    "commands",
]
exclude_patterns = ["_build", "_templates", "extensions", "figures"]
source_suffix = {".rst": "restructuredtext", ".md": "myst-nb"}
templates_path = ["_templates"]
MODULES = ROOT / "docs" / "api" / "modules"
autosummary_generate = [f"api/modules/{page.name}" for page in MODULES.glob("*.md")]
default_role = "py:obj"

myst_enable_extensions = ["dollarmath", "deflist", "colon_fence", "substitution", "attrs_inline"]
myst_heading_anchors = 3
myst_dmath_double_inline = False
nb_execution_mode = "force"
nb_execution_in_temp = True  # notebooks find nothing but what they write
nb_execution_raise_on_error = True
nb_execution_timeout = 600  # with kernels to be compiled [s]
nb_execution_show_tb = True
nb_output_stderr = "remove"  # bars of progress
nb_merge_streams = True
nb_render_image_options = {"width": "520px"}
os.environ["JUPYTER_PATH"] = str(ROOT / "docs" / "extensions" / "jupyter")  # its kernel is silent
suppress_warnings = ["myst.xref_missing_text"]

highlight_language = "none"
nitpicky = True
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_inherit_docstrings = False
napoleon_numpy_docstring = False
napoleon_use_rtype = False
python_use_unqualified_type_names = True
toc_object_entries = False
add_module_names = False

html_theme = "furo"
html_title = f"springback {release}"
html_static_path = ["_static"]
html_css_files = ["springback.css"]
html_js_files = ["copy.js"]
html_math_renderer = "mathml"
html_copy_source = False
html_search_scorer = str(ROOT / "docs" / "extensions" / "scorer.js")
html_show_search_summary = False  # pages opened from a disk may not read each other
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {
    "navigation_with_keys": True,
    "light_css_variables": {"color-brand-primary": "#0b5394", "color-brand-content": "#0b5394"},
    "dark_css_variables": {"color-brand-primary": "#8ab8ff", "color-brand-content": "#8ab8ff"},
}
pygments_style = "friendly"
pygments_dark_style = "monokai"
