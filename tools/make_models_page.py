#!/usr/bin/env python3
# Writes docs/models.md: every model of the gallery with its picture, which the program makes.
# SPDX-License-Identifier: MIT
"""Usage: tools/make_models_page.py           the page and its pictures (builds kiri where it is not built)
       tools/make_models_page.py --check   says whether the page is that of the models as they are"""

import html
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

Every model of chapter 7 of the [thesis](https://algorithmicbotany.org/papers/sjazebi.th2012.html), and some friends: {links}.
Each is a file in [examples/](../examples): a sheet and a list of steps, with a title and a note for every step. The number of steps
says about how long it takes. For a class, a talk or a table with scissors:

```sh
./kirisim examples/origami_cup.kiri                                    # step by step in the window
./kiri sheet examples/origami_cup.kiri -o cup.pdf                      # its steps side by side, to print
./kiri render examples/origami_cup.kiri --view pattern -o pattern.pdf  # its crease pattern in true size
./kiri animate examples/origami_cup.kiri -o cup.mp4                    # a film
./kiri gallery -o gallery                                              # pages of all models with all of this
```

The window shows the models on its start page too. The pictures here were made by the program; `tools/make_models_page.py`
makes this page again.
"""


def first_sentence(notes):
    """Up to the full stop that ends the first sentence, as the gallery has it."""
    return re.split(r"(?<=\.) (?=[A-Z])", notes, maxsplit=1)[0]


def cell(name):
    model = json.loads((ROOT / "examples" / name).read_text(encoding="utf-8"))
    picture = f"pictures/models/{Path(name).stem}.png"
    title = html.escape(model["title"])
    steps = len(model["steps"])
    return (f'<td width="{100 // COLUMNS}%" valign="top"><img src="{picture}" width="170" alt="{title}"><br>\n'
            f'<b><a href="../examples/{name}">{title}</a></b><br>{html.escape(first_sentence(model["notes"]))}<br>\n'
            f'<sub>{steps} step{"" if steps == 1 else "s"}</sub></td>')


def table(models):
    """Of HTML, for the columns of Markdown's are as wide as their words want."""
    lines = ["<table>"]
    for start in range(0, len(models), COLUMNS):
        lines += ["<tr>", *(cell(name) for name in models[start:start + COLUMNS]), "</tr>"]
    return "\n".join([*lines, "</table>"])


def anchor(title):
    """The name that pages of Markdown give to a heading."""
    return title.lower().replace(" ", "-")


def page(gallery):
    titles = [group["title"] for group in gallery["groups"]]
    links = ", ".join(f"[{title[0].lower()}{title[1:]}](#{anchor(title)})" for title in titles)
    parts = [INTRODUCTION.replace("{links}", links)]
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
