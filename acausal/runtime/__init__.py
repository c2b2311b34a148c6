"""The run-time in C that compiled models are integrated by, and what builds, loads and calls it.

The C files stand beside this one and are part of the wheel. `build` compiles and caches, `binding` mirrors
`acausal_runtime.h`.
"""
