"""Histories of vehicles whose arms are on joints."""
