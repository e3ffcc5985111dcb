"""Command line, with a module for every one or two commands."""
