"""What judges measure with; like the judges, it is hidden from what students run in grading."""
