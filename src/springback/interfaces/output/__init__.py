"""Folders, files and text that commands leave, and how they end."""
