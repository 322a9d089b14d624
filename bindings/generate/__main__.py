"""Makes all that follows from the public headers: api.json, and what each binding makes of it.

    python3 bindings/generate            after every change of a public header
    python3 bindings/generate --check    fails if a file is out of date
"""
import subprocess
import sys
from pathlib import Path

BINDINGS = Path(__file__).resolve().parents[1]


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    for script in [BINDINGS / "describe.py", *sorted(BINDINGS.glob("*/generate.py"))]:
        if subprocess.run([sys.executable, "-B", script, *sys.argv[1:]], check=False).returncode:
            sys.exit(1)


if __name__ == "__main__":
    main()
