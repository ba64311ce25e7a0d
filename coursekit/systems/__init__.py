"""The differences between Linux, macOS and Windows: no other room asks for the system, or uses parts of only one."""
