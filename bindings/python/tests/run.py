#!/usr/bin/env python3
"""Runs the tests of the Python package, and then says which functions of the library none of them called with success.

    run.py [--without-numpy] [--installed] [NAME...]

    --without-numpy   as if NumPy were not installed
    --installed       tests the installed package instead of the one beside this folder
    NAME              only these, such as test_chain or test_chain.Fields: what was called is not looked at then

The library is found as the package finds it: see CONTDYN_LIBRARY in README.md.
"""
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent


def count_calls(library, names):
    """Puts a counting function around each of the library's; the counts of successful calls, by name."""
    calls = dict.fromkeys(names, 0)

    def counting(name, function):
        def call(*arguments):
            result = function(*arguments)
            if result == 0 or not name.startswith(("cd_chain", "cd_membrane", "cd_water")) or name.endswith("_destroy"):
                calls[name] += 1
            return result

        return call

    for name in names:
        setattr(library, name, counting(name, getattr(library, name)))
    return calls


def main():
    options = [word for word in sys.argv[1:] if word.startswith("--")]
    names = [word for word in sys.argv[1:] if not word.startswith("--")]
    if set(options) - {"--without-numpy", "--installed"}:
        sys.exit(__doc__)
    if "--without-numpy" in options:
        sys.modules["numpy"] = None
    sys.path.insert(0, str(HERE))
    if "--installed" not in options:
        sys.path.insert(0, str(HERE.parent))

    from contdyn import _api, _arrays, _library  # the paths had to be set first

    calls = count_calls(_library.library, _api.FUNCTIONS)
    print(f"Python {sys.version.split()[0]}, {'with' if _arrays.numpy else 'without'} NumPy, {_library.path}")
    loader = unittest.defaultTestLoader
    tests = loader.loadTestsFromNames(names) if names else loader.discover(str(HERE))
    result = unittest.TextTestRunner(verbosity=1).run(tests)
    never = [name for name, count in calls.items() if count == 0]
    if never and not names:
        sys.exit(f"never called with success: {', '.join(never)}")
    sys.exit(not result.wasSuccessful())


if __name__ == "__main__":
    main()
