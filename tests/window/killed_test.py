#!/usr/bin/env python3
# Kills the window at random moments: at most the step under the hand is lost.
# SPDX-License-Identifier: MIT

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("KIRISIM_PROGRAM", "")
KILLS = int(os.environ.get("KIRI_KILLS", "50"))
WAIT = 60  # seconds for what should take a blink, on a machine that does other things too


def steps_in(journal):
    """The steps that a journal keeps: its first line is about the file, the rest is the model."""
    text = journal.read_text(encoding="utf-8")
    return len(json.loads(text[text.index("{", text.index("\n")):])["steps"])


class Killed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.environment = dict(os.environ, HOME=self.folder.name, XDG_DATA_HOME=self.folder.name + "/data",
                                XDG_CONFIG_HOME=self.folder.name + "/config", XDG_RUNTIME_DIR=self.folder.name)
        self.model = Path(self.folder.name) / "sheet.kiri"
        self.model.write_text('{"format": "kiri", "version": 1, "sheet": {"shape": "square", "side": 100}, "steps": []}',
                              encoding="utf-8")

    def tearDown(self):
        self.folder.cleanup()

    def journals(self):
        return sorted((Path(self.folder.name) / "data").rglob("*.journal"))

    def kept(self):
        """The most steps that any journal keeps; every journal can be read."""
        return max((steps_in(journal) for journal in self.journals()), default=0)

    def wait_for(self, holds, what):
        end = time.monotonic() + WAIT
        while not holds():
            self.assertLess(time.monotonic(), end, f"{what} did not happen")
            self.assertIsNone(self.window.poll(), f"the window ended by itself before {what}")
            time.sleep(0.01)

    def press(self, key):
        subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "KiriSim", "windowfocus", "--sync", "key", key],
                       env=self.environment, check=False, capture_output=True)

    def is_shown(self):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "sheet.kiri"], env=self.environment,
                               capture_output=True, text=True)
        return bool(found.stdout.strip())

    def test_loses_at_most_the_step_under_the_hand(self):
        chance = random.Random(20121)
        for kill in range(KILLS):
            with self.subTest(kill=kill):
                self.window = subprocess.Popen([PROGRAM, "--software", str(self.model)], env=self.environment,
                                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                try:
                    self.wait_for(self.is_shown, "opening the model")
                    done = chance.randrange(3)
                    for step in range(done):
                        self.press("x")
                        self.wait_for(lambda step=step: self.kept() >= step + 1, f"step {step + 1}")
                    self.press("x")
                    time.sleep(chance.random() * 0.15)
                finally:
                    self.window.send_signal(signal.SIGKILL)
                    self.window.wait()
                self.assertGreaterEqual(self.kept(), done)
                self.assertLessEqual(self.kept(), done + 1)
                for journal in self.journals():
                    journal.unlink()


if __name__ == "__main__":
    if not PROGRAM or not os.environ.get("DISPLAY") or not shutil.which("xdotool"):
        print("no window, no screen or no xdotool: skipped")
        sys.exit(77)
    unittest.main()
