"""Campaigns: many flights by a plan, stored in a folder, resumed and queried."""
