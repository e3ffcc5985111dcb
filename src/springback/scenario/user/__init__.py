"""Parts of a flight that are the user's own code: obstacles, pilots, estimators, detectors."""
