"""Scene and study files, and the datasets built from them; only this package uses YAML and HDF5."""
