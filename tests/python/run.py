#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The tests of the package for Python:  tests/python/run.py BUILD [-v] [TEST...]"""

import os
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
TREES = tempfile.TemporaryDirectory()


def main() -> None:
    build = pathlib.Path(sys.argv[1]).resolve()
    os.environ["IMPETUS"] = str(build / "impetus")
    os.environ["PYTHONPATH"] = str(build / "python")
    os.environ["IMPETUS_TREE_CACHE"] = TREES.name  # never the user's own
    sys.path[:0] = [str(build / "python"), str(HERE)]
    os.chdir(HERE.parent.parent)
    arguments = sys.argv[2:]
    named = [each for each in arguments if not each.startswith("-")]
    program = unittest.main(
        module=None,
        argv=["run.py", *([] if named else ["discover", "-s", str(HERE)]), *arguments],
        exit=False,
    )
    sys.exit(0 if program.result.wasSuccessful() and program.result.testsRun > 0 else 1)


if __name__ == "__main__":
    main()
