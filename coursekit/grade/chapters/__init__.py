"""The judges of each chapter's exercises: they look at behaviour and properties, never at a model answer."""
