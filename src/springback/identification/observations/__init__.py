"""Observations of impacts: windows of logs, noise, what sensors would tell, likelihood."""
