"""Two vehicles of one scenario: flown together, and their contacts again."""
