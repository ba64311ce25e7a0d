"""Interfaces: parameters and logging."""
