"""Exercises: what is asked, the checks that judge it, the student's copy, progress."""
