"""The official tutorials, page by page: files of our own that do what the pages' files do, and the pages' commands."""
