"""The equations of motion against independent ones, and against the laws of mechanics."""
