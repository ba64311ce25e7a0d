"""twist_mux: one of several drivers steers, by priority."""
