#!/usr/bin/env python3
# What README shows is true: its commands work, its sample is the example that is built, its links lead somewhere.
# SPDX-License-Identifier: MIT

import os
import re
import shlex
import subprocess
import tempfile
import textwrap
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", README, re.S | re.M)


class Readme(unittest.TestCase):
    def test_fits_on_a_screen(self):
        self.assertLessEqual(len(README.splitlines()), 60)

    def test_links_lead_somewhere(self):
        links = re.findall(r"\]\(([^)#]+)\)", README)
        self.assertGreater(len(links), 5)
        for link in links:
            if not link.startswith("http"):
                self.assertTrue((ROOT / link).exists(), f"README links to {link}, which does not exist")

    def test_the_sample_is_the_example(self):
        (sample,) = blocks("cpp")
        example = (ROOT / "examples/first_fold.cpp").read_text(encoding="utf-8")
        self.assertIn(textwrap.indent(sample, "  "), example)

    def test_the_example_prints_what_readme_says(self):
        program = Path(os.environ["KIRI_BINARY_DIR"]) / "example_first_fold"
        output = subprocess.run([program], capture_output=True, text=True, check=True, timeout=60).stdout
        self.assertIn(f"it prints `{output.strip()}`", README)

    def test_the_commands_work(self):
        (commands,) = blocks("sh")
        # Without a screen: there `./kirisim` makes a picture instead of opening a window that nobody closes.
        screens = ("DISPLAY", "WAYLAND_DISPLAY")
        environment = {name: value for name, value in os.environ.items() if name not in screens}
        with tempfile.TemporaryDirectory() as folder:
            for name in ("kiri", "kirisim", "examples"):
                (Path(folder) / name).symlink_to(ROOT / name)
            before = set(os.listdir(folder))
            for line in commands.splitlines():
                words = shlex.split(line, comments=True)
                if words[0] == "./test":
                    continue  # this is what runs now
                run = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
                self.assertEqual(run.returncode, 0, f"{line}\n{run.stderr}")
                made = set(os.listdir(folder)) - before
                self.assertEqual(len(made), 1, f"{line} made {sorted(made)}")
                before |= made
                if "-o" in words:
                    self.assertEqual(made, {words[words.index("-o") + 1]})


if __name__ == "__main__":
    unittest.main()
