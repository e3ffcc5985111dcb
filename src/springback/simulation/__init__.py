"""Flights: the loop over steps and ticks, lanes, records and measures."""
