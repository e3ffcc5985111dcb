"""The experiments of Liu & Karydis, one module for each table or figure."""
