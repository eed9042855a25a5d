#!/usr/bin/env python3
# Films of examples, as ffprobe and webpinfo see them, and Ctrl-C in the midst of one.
# SPDX-License-Identifier: MIT
"""Skipped (exit code 77) where ffmpeg or webpinfo is missing; ./test installs them."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("KIRI_PROGRAM", str(ROOT / "build/release/kiri"))
SKIPPED = 77


def children_of(pid):
    """The processes whose parent is `pid`."""
    return [int(word) for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


class Films(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def animate(self, name, example, *options):
        out = self.folder / name
        run = subprocess.run([PROGRAM, "animate", str(ROOT / f"examples/{example}.kiri"), "-o", str(out), *options],
                             capture_output=True, text=True, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        return out

    def probe(self, film):
        run = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-of", "default=nw=1", "-show_entries",
                              "stream=codec_name,width,height,pix_fmt,duration,nb_read_frames", str(film)],
                             capture_output=True, text=True, check=True)
        self.assertEqual(run.stderr, "")
        return dict(line.split("=") for line in run.stdout.split())

    def test_examples_as_mp4_have_the_frames_of_their_time(self):
        for example in ("ship", "leaf_palmate", "leaf_hornbeam"):
            seen = self.probe(self.animate(example + ".mp4", example, "--size", "160x120", "--fps", "10", "--speed", "720",
                                           "--hold", "0.1"))
            self.assertEqual((seen["codec_name"], seen["width"], seen["height"], seen["pix_fmt"]),
                             ("h264", "160", "120", "yuv420p"))
            self.assertGreater(int(seen["nb_read_frames"]), 20)
            self.assertAlmostEqual(float(seen["duration"]) * 10, int(seen["nb_read_frames"]), delta=0.01)

    def test_gif_and_webp_last_as_long_as_mp4(self):
        options = ("--size", "160x120", "--fps", "10", "--steps", "1-3")
        frames = int(self.probe(self.animate("ship.mp4", "ship", *options))["nb_read_frames"])
        gif = self.probe(self.animate("ship.gif", "ship", *options))
        self.assertEqual(int(gif["nb_read_frames"]), frames)
        self.assertAlmostEqual(float(gif["duration"]), frames / 10, delta=0.01)
        info = subprocess.run(["webpinfo", str(self.animate("ship.webp", "ship", *options))], capture_output=True,
                              text=True, check=True).stdout
        self.assertIn("No error detected.", info)
        lasts = sum(int(line.split()[1]) for line in info.splitlines() if line.strip().startswith("Duration:"))
        self.assertEqual(lasts, frames * 100)

    def test_ctrl_c_ends_ffmpeg_and_leaves_nothing(self):
        for name in ("film.mp4", "film.gif", "film_%d.png"):
            kiri = subprocess.Popen([PROGRAM, "animate", str(ROOT / "examples/leaf_palmate.kiri"), "-o",
                                     str(self.folder / name), "--fps", "200", "--size", "800x600"],
                                    stderr=subprocess.PIPE, text=True)
            helpers = []
            for _ in range(600):
                time.sleep(0.05)
                helpers = children_of(kiri.pid)
                if list(self.folder.iterdir()) and (helpers or "%d" in name):
                    break
            self.assertTrue(list(self.folder.iterdir()), "the work has begun")
            kiri.send_signal(signal.SIGINT)
            _, said = kiri.communicate(timeout=60)
            self.assertEqual((kiri.returncode, said), (4, "error: stopped; nothing was written\n"), name)
            self.assertEqual(list(self.folder.iterdir()), [], name)
            for helper in helpers:
                self.assertFalse(Path(f"/proc/{helper}").exists(), name)


if __name__ == "__main__":
    missing = [program for program in ("ffmpeg", "ffprobe", "webpinfo") if not shutil.which(program)]
    if missing:
        print("skipped: there is no " + ", ".join(missing))
        sys.exit(SKIPPED)
    unittest.main()
