"""The judges' measures; like the judges, they are hidden from programs that students run in grading."""
