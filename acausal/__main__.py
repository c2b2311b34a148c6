"""`python -m acausal` is the command `acausal`."""

import sys

from acausal.cli import main

if __name__ == "__main__":
    sys.exit(main())
