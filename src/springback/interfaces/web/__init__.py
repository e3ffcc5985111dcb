"""Pages for a browser, and their server."""
