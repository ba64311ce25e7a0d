"""Interfaces: single values."""
