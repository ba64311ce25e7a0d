"""Checks that source files start with a copyright notice."""
