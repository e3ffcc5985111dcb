"""Many scenarios at once, set up together and flown in lanes."""
