"""Interfaces: what sensors measure."""
