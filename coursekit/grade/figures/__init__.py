"""What checks draw beside their verdicts: figures of plain values that a judge has checked. They hold no answers."""
