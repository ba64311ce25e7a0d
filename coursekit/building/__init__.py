"""The steps when coursekit is built or installed: generated files of the underlay, and the students' chapters."""
