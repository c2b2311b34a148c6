"""The kernels: each module holds one, with its evaluation and derivatives."""
