"""Interfaces: unique identifiers."""
