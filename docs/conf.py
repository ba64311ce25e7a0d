"""How these pages are built: `make docs`."""

project = "coursekit"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
html_theme = "furo"
html_title = "coursekit"
exclude_patterns = ["README.md"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 3
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "undoc-members": False, "show-inheritance": True}
autodoc_typehints = "signature"
autodoc_use_type_comments = False
suppress_warnings = ["ref.python", "docutils"]  # docstrings are plain text, and their types are not all documented
