"""Interfaces of logging_demo."""
