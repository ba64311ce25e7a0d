"""Exercises: tasks, the checks that judge them, the student's copy, and progress."""
