"""`python -m planar_pushing` is the command `planar-pushing`."""

import sys

from planar_pushing.commands import main

sys.exit(main())
