"""Interfaces: coordinate frames."""
