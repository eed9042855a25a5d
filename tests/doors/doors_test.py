#!/usr/bin/env python3
# The doors kiri, kirisim and test, as a person meets them.
# SPDX-License-Identifier: MIT

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEAF = ROOT / "examples/leaf_palmate.kiri"
PNG_START = b"\x89PNG\r\n\x1a\n"


def run(door, *arguments, cwd=None):
    """The door as it is met where there is no screen."""
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([ROOT / door, *arguments], cwd=cwd, capture_output=True, text=True, timeout=300,
                          env=environment)


class Kiri(unittest.TestCase):
    def test_help_names_every_command(self):
        help_text = run("kiri", "--help")
        self.assertEqual(help_text.returncode, 0)
        for command in ("render", "sheet", "info", "export"):
            self.assertIn(command, help_text.stdout)
            of_command = run("kiri", command, "--help")
            self.assertEqual(of_command.returncode, 0, command)
            self.assertIn("xample", of_command.stdout, f"kiri {command} --help shows no example")

    def test_an_unknown_command_is_a_mistake_of_usage(self):
        wrong = run("kiri", "unfurl")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("unfurl", wrong.stderr)
        self.assertEqual(wrong.stdout, "")

    def test_a_missing_file_is_named(self):
        missing = run("kiri", "info", "no_such_leaf.kiri")
        self.assertNotIn(missing.returncode, (0, 2))
        self.assertIn("no_such_leaf.kiri", missing.stderr)
        self.assertEqual(missing.stdout, "")

    def test_paths_count_from_the_folder_of_the_caller(self):
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder) / "a folder"
            here.mkdir()
            (here / "my leaf.kiri").write_bytes(LEAF.read_bytes())
            drawn = run("kiri", "render", "my leaf.kiri", "-o", "my leaf.png", cwd=here)
            self.assertEqual(drawn.returncode, 0, drawn.stderr)
            self.assertTrue((here / "my leaf.png").read_bytes().startswith(PNG_START))

    def test_works_through_a_symbolic_link(self):
        with tempfile.TemporaryDirectory() as folder:
            link = Path(folder) / "link"
            link.symlink_to(ROOT / "kiri")
            linked = subprocess.run([link, "--help"], cwd=folder, capture_output=True, text=True, timeout=300)
            self.assertEqual(linked.returncode, 0, linked.stderr)


class Kirisim(unittest.TestCase):
    def test_shows_the_steps_that_it_means(self):
        self.assertIn("--steps 14-16", (ROOT / "kirisim").read_text(encoding="utf-8"))
        steps = json.loads(LEAF.read_text(encoding="utf-8"))["steps"]
        self.assertEqual([step["do"] for step in steps[12:]], ["refold", "curve cut", "unfold"])

    def test_draws_the_leaf_and_says_where(self):
        with tempfile.TemporaryDirectory() as folder:
            leaf = run("kirisim", cwd=folder)
            self.assertEqual(leaf.returncode, 0, leaf.stderr)
            place = Path(leaf.stdout.strip())
            self.assertEqual(place.parent.resolve(), Path(folder).resolve())
            self.assertTrue(place.read_bytes().startswith(PNG_START))
            self.assertIn("no screen", leaf.stderr)
            self.assertIn("leaf", leaf.stderr)

    def test_draws_the_given_file(self):
        with tempfile.TemporaryDirectory() as folder:
            leaf = run("kirisim", os.path.relpath(LEAF, folder), cwd=folder)
            self.assertEqual(leaf.returncode, 0, leaf.stderr)
            self.assertTrue((Path(folder) / "kirisim-leaf_palmate.png").read_bytes().startswith(PNG_START))

    def test_says_what_it_does_not_know(self):
        self.assertEqual(run("kirisim", "--help").returncode, 0)
        self.assertEqual(run("kirisim", "--window").returncode, 2)
        self.assertEqual(run("kirisim", "a.kiri", "b.kiri").returncode, 2)
        self.assertNotEqual(run("kirisim", "no_such_leaf.kiri").returncode, 0)


class Test(unittest.TestCase):
    def test_says_what_it_does_not_know(self):
        self.assertEqual(run("test", "--help").returncode, 0)
        wrong = run("test", "quickly")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("quickly", wrong.stderr)

    def test_is_what_runs_on_every_change(self):
        self.assertEqual(run(".ci/run", "--help").stdout, run("test", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
