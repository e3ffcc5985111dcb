"""Arms of a vehicle: their settings, and those on joints."""
