"""After a collision: notice it, make out what it was, and fly away from it."""
