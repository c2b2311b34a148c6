"""Sphinx configuration: the pages are Markdown and also read well unbuilt."""

from importlib.metadata import version as installed_version

project = "acausal"
author = "The acausal developers"
copyright = "2026, the acausal developers"
release = version = installed_version("acausal")

extensions = ["myst_parser"]
exclude_patterns = ["_build"]
nitpicky = True

myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3

html_theme = "furo"
html_title = "acausal"
