"""What differs between Linux, macOS and Windows: nothing else asks which system it is, or uses what only one of them has."""
