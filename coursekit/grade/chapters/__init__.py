"""The judges of each chapter's exercises: they check behaviour and properties, never a model answer."""
