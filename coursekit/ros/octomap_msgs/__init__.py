"""Interfaces: maps of space as octrees."""
