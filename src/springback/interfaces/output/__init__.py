"""Output of commands: folders, files and text; interruption."""
