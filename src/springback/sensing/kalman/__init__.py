"""Inertial navigation by an error-state Kalman filter, in blocks of three."""
