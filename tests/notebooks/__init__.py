"""The chapters as tests: executed and compared, run twice, handed out, solved and failed."""
