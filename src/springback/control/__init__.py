"""Control: references, controllers, the mixing of rotors."""
