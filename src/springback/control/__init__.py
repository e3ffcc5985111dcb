"""What a vehicle tries: references, controllers, the mixing of rotors."""
