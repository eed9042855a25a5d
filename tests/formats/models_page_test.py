#!/usr/bin/env python3
# The page of all models shows the models as they are, each with a picture.
# SPDX-License-Identifier: MIT

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class ModelsPage(unittest.TestCase):
    def test_says_what_the_models_say(self):
        run = subprocess.run([sys.executable, ROOT / "tools/make_models_page.py", "--check"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_has_its_pictures_and_no_others(self):
        page = (ROOT / "docs/models.md").read_text(encoding="utf-8")
        shown = set(re.findall(r'src="pictures/models/([^"]+)"', page))
        there = {picture.name for picture in (ROOT / "docs/pictures/models").glob("*")}
        self.assertEqual(shown, there)
        self.assertGreater(len(shown), 30)


if __name__ == "__main__":
    unittest.main()
