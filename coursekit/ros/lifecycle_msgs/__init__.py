"""Interfaces: states and transitions of managed nodes."""
