"""Wrong answers by chapter: `WRONG` maps an exercise to texts for its solution cell, each of which must fail; `RIGHT` to others that must pass."""
