"""Interfaces: places on the earth, maps and routes."""
