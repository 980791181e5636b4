"""From public arguments to the kernels of the core, and back."""
