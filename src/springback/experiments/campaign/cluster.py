"""Flying on a Dask cluster."""
