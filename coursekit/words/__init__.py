"""The texts of panels and checks, in the language of the course; `es.po` and its like hold the translations."""
