"""The differences between Linux, macOS and Windows: no other package checks the system, or uses features of only one."""
