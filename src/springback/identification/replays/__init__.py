"""Replays of recorded impacts: flown from the recorded start, and compared with the record."""
