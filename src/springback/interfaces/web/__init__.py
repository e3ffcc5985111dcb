"""Pages for a browser, and the server that hands them out."""
