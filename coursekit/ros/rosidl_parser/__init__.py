"""The types of fields (see `definition`)."""
