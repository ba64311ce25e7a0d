"""Helpers that navigation's launch files share."""
