"""Scene and study files, and the datasets built from them: the one place that knows YAML and HDF5."""
