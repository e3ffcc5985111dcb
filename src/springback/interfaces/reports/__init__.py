"""Reports: pages that need nothing else, and the files of a flight."""
