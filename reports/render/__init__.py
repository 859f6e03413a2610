"""The report: evidence records and their arrays in, static HTML with figures out. Never runs or links a solver."""
