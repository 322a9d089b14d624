"""Makes pages to browse of the whole API, from bindings/api.json: one file, index.html, which needs no network.

    python3 bindings/reference FOLDER    writes FOLDER/index.html
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parent / "generate")]
from description import Description  # noqa: E402
from page import Page  # noqa: E402


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(Page(Description()).text(), encoding="utf-8")


if __name__ == "__main__":
    main()
