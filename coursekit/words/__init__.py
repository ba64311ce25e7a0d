"""The texts of panels and checks in the language of the course; `es.po` and similar files hold the translations."""
