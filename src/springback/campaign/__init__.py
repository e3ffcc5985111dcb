"""Campaigns: many flights by a plan, kept in a folder, resumed and queried."""
