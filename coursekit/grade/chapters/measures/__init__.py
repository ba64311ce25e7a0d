"""The judges' measurements; like the judges, they are hidden from students' programs during grading."""
