"""Interfaces: one interface for each feature of the language."""
