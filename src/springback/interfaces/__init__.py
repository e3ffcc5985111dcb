"""How people reach it: command line, files, figures, report."""
