"""Studies: trials, run-ups, envelopes, ablations and what is said of them."""
