"""Identification: numbers of a vehicle and its obstacles from recordings of impacts."""
