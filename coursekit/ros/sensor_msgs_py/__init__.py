"""Helpers for sensor messages."""
