"""Interfaces: services of the mapping node."""
