"""The build and install steps of coursekit: generated files of the underlay, and the students' chapters."""
