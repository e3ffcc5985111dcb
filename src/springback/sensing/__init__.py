"""What a vehicle can know: sensors and estimators."""
