"""Interfaces: time and duration."""
