"""twist_mux: selects one of several velocity sources by priority."""
