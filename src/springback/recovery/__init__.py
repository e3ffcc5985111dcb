"""Collisions in flight: detection, characterisation, response, and their evaluation."""
