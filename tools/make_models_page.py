#!/usr/bin/env python3
# Writes docs/models.md: every model of the gallery with its picture, which the program makes.
# SPDX-License-Identifier: MIT
"""Usage: tools/make_models_page.py           the page and its pictures (builds kiri where it is not built)
       tools/make_models_page.py --check   says whether the page is that of the models as they are"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/models.md"
PICTURES = ROOT / "docs/pictures/models"
COLUMNS = 4
INTRODUCTION = """# The models

Every model of chapter 7 of the [thesis](https://algorithmicbotany.org/papers/sjazebi.th2012.html), and some friends. Each is a file in
[examples/](../examples): a sheet and a list of steps, with a title and a note for every step. The window shows them on its
start page, and one command makes a page of them all, with pictures folded, half unfolded and unfolded, crease patterns, films,
step sheets and downloads:

```sh
./kiri gallery -o gallery
```

The pictures here were made by the program; `tools/make_models_page.py` makes this page again.
"""


def first_sentence(notes):
    """Up to the first full stop that ends a sentence, not that of a figure's number or of "A. saccharum"."""
    return re.split(r"(?<=[a-z0-9)]{2}\.)\s", notes, maxsplit=1)[0]


def cell(name):
    model = json.loads((ROOT / "examples" / name).read_text(encoding="utf-8"))
    picture = f"pictures/models/{Path(name).stem}.png"
    text = first_sentence(model["notes"]).replace("|", "\\|")
    return (f'<img src="{picture}" width="170" alt="{model["title"]}"><br>'
            f'**[{model["title"]}](../examples/{name})**<br>{text}')


def table(models):
    lines = ["| " * COLUMNS + "|", "| --- " * COLUMNS + "|"]
    for start in range(0, len(models), COLUMNS):
        cells = [cell(name) for name in models[start:start + COLUMNS]]
        cells += [""] * (COLUMNS - len(cells))
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def page(gallery):
    parts = [INTRODUCTION]
    for group in gallery["groups"]:
        parts.append(f"## {group['title']}\n\n{group['notes']}\n\n{table(group['models'])}\n")
    return "\n".join(parts)


def make_pictures(gallery):
    PICTURES.mkdir(parents=True, exist_ok=True)
    for old in PICTURES.glob("*.png"):
        old.unlink()
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([ROOT / "kiri", "gallery", "-o", folder, "--no-animations"], check=True)
        index = (Path(folder) / "index.html").read_text(encoding="utf-8")
        for picture in re.findall(r', (\S+) 480w"', index):
            shutil.copyfile(Path(folder) / picture, PICTURES / f"{Path(picture).parent}.png")


def main():
    gallery = json.loads((ROOT / "examples/gallery.json").read_text(encoding="utf-8"))
    if sys.argv[1:] == ["--check"]:
        if PAGE.read_text(encoding="utf-8") != page(gallery):
            sys.exit("docs/models.md is not that of examples/gallery.json; run tools/make_models_page.py")
        return
    make_pictures(gallery)
    PAGE.write_text(page(gallery), encoding="utf-8")


if __name__ == "__main__":
    main()
