"""User interfaces: command line, files, figures, reports, pages."""
