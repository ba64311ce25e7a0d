"""Interfaces: updates and parts of maps."""
