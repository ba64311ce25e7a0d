"""The figures beside verdicts: they show plain values validated by a judge, and contain no answers."""
