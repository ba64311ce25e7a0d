"""Interfaces: health of devices and programs."""
