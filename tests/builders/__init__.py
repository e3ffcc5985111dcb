"""Scenes, flights, plans and results that several tests share; nothing here is a test."""
