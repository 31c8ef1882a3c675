"""Reports: they read a ledger and never run a check."""
