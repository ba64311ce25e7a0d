"""Interfaces: navigation: costmaps, planning, behaviours."""
