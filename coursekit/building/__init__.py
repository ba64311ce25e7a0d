"""What is done when coursekit is built or installed: files of the underlay that are made, and the students' chapters."""
