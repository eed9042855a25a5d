#!/usr/bin/env python3
# The bootstrap that the three doors share, run in a small tree with stand-ins for dpkg, apt and cmake.
# SPDX-License-Identifier: MIT

import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DPKG_QUERY = """#!/bin/sh
for name in $HAVE; do printf 'installed=%s ' "$name"; done
"""
APT_GET = """#!/bin/sh
printf '%s\\n' "$*" >>"$RECORD"
"""
CMAKE = """#!/bin/sh
sleep 0.2
printf 'cmake %s\\n' "$*" >>"$RECORD"
mkdir -p build/release
: >build/release/build.ninja
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\\n' "$PWD" >build/release/CMakeCache.txt
printf '#!/bin/sh\\necho "built: $*"\\nexit 5\\n' >build/release/kiri
chmod +x build/release/kiri
"""


class Bootstrap(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(os.path.realpath(self.folder.name)) / "a tree with spaces"
        self.bin = Path(self.folder.name) / "bin"
        self.record = Path(self.folder.name) / "record"
        (self.root / "tools").mkdir(parents=True)
        (self.root / "core").mkdir()
        (self.root / "core/a.cpp").write_text("")
        self.bin.mkdir()
        for name in ("kiri", "tools/bootstrap.sh", "tools/packages.txt"):
            (self.root / name).write_bytes((ROOT / name).read_bytes())
        (self.root / "kiri").chmod(0o755)
        self.stand_in("dpkg-query", DPKG_QUERY)
        self.stand_in("apt-get", APT_GET)
        self.stand_in("sudo", '#!/bin/sh\nexec "$@"\n')
        self.stand_in("cmake", CMAKE)
        self.have = ""  # packages that count as installed
        self.have = " ".join(self.packages("kiri", "test"))

    def tearDown(self):
        self.folder.cleanup()

    def stand_in(self, name, text):
        (self.bin / name).write_text(text)
        (self.bin / name).chmod(0o755)

    def environment(self):
        return dict(os.environ, PATH=f"{self.bin}:{os.environ['PATH']}", RECORD=str(self.record), HAVE=self.have)

    def run_bash(self, script):
        setup = (f"set -euo pipefail; KIRI_ROOT='{self.root}'; . \"$KIRI_ROOT/tools/bootstrap.sh\"; "
                 'mkdir -p "$KIRI_BUILD"; ')
        return subprocess.run(["bash", "-c", setup + script], env=self.environment(), capture_output=True,
                              text=True, timeout=60)

    def packages(self, *doors):
        return self.run_bash("packages_of " + " ".join(doors)).stdout.split()

    def recorded(self):
        return self.record.read_text() if self.record.exists() else ""

    def door(self, *arguments, **options):
        return subprocess.run([self.root / "kiri", *arguments], env=self.environment(), capture_output=True,
                              text=True, timeout=60, **options)

    def test_every_package_has_a_door_and_a_reason(self):
        for line in (ROOT / "tools/packages.txt").read_text().splitlines():
            if line and not line.startswith("#"):
                self.assertRegex(line, r"^[a-z0-9.+-]+ +(kiri|kirisim|test) +(unless=\S+ +)?[^\s=]+( .*)?$")

    def test_the_program_needs_less_than_the_tests(self):
        self.assertIn("g++", self.packages("kiri"))
        self.assertNotIn("libgtest-dev", self.packages("kiri"))
        self.assertIn("libgtest-dev", self.packages("kiri", "test"))

    def test_nothing_is_installed_when_nothing_is_missing(self):
        self.assertEqual(self.run_bash("install_missing kiri test").returncode, 0)
        self.assertEqual(self.recorded(), "")

    def test_only_what_is_missing_is_installed_and_locks_are_waited_for(self):
        self.have = " ".join(set(self.packages("kiri")) - {"cmake", "g++"})
        self.assertEqual(self.run_bash("install_missing kiri").returncode, 0)
        update, install = self.recorded().splitlines()
        self.assertTrue(update.endswith("update"), update)
        self.assertTrue(install.endswith("install --no-install-recommends g++ cmake"), install)
        self.assertIn("DPkg::Lock::Timeout=600", install)

    def test_a_command_from_elsewhere_stands_for_its_package(self):
        (self.root / "tools/packages.txt").write_text(
            "g++  kiri  the compiler\nsome-tool  kiri  unless=some-tool-command does a thing\n")
        self.assertEqual(self.packages("kiri"), ["g++", "some-tool"])
        self.stand_in("some-tool-command", "#!/bin/sh\n")
        self.assertEqual(self.packages("kiri"), ["g++"])
        self.have = "g++"
        self.assertEqual(self.run_bash("install_missing kiri").returncode, 0)
        self.assertEqual(self.recorded(), "")

    def test_a_failing_installation_says_what_to_do(self):
        self.have = ""
        self.stand_in("apt-get", "#!/bin/sh\necho 'E: no network'\nexit 100\n")
        run = self.run_bash("install_missing kiri")
        self.assertEqual(run.returncode, 70)
        self.assertIn("E: no network", run.stderr)
        self.assertIn("apt-get install", run.stderr)

    def test_builds_once_and_starts_at_once_after(self):
        first = self.door("one", "two words")
        self.assertEqual((first.stdout, first.returncode), ("built: one two words\n", 5), first.stderr)
        builds = self.recorded()
        second = self.door("three")
        self.assertEqual((second.stdout, second.stderr), ("built: three\n", ""))
        self.assertEqual(self.recorded(), builds)

    def test_builds_again_when_a_source_changes_comes_or_goes(self):
        self.door()
        for change in ((self.root / "core/a.cpp").touch, (self.root / "core/b.cpp").touch,
                       (self.root / "core/b.cpp").unlink):
            time.sleep(0.05)
            before = self.recorded()
            change()
            self.door()
            self.assertNotEqual(self.recorded(), before)
            before = self.recorded()
            self.door()
            self.assertEqual(self.recorded(), before)

    def test_two_at_once_build_once(self):
        runs = [subprocess.Popen([self.root / "kiri"], env=self.environment(), stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True) for _ in range(2)]
        outputs = [run.communicate(timeout=60)[0] for run in runs]
        self.assertEqual(outputs, ["built: \n"] * 2)
        self.assertEqual(self.recorded().count("--build"), 1)

    def test_a_moved_folder_is_built_anew(self):
        self.door()
        moved = self.root.parent / "moved"
        self.root.rename(moved)
        self.root = moved
        (self.root / "core/a.cpp").touch()
        run = self.door()
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("another place", run.stderr)

    def test_a_failing_build_shows_the_error(self):
        self.stand_in("cmake", "#!/bin/sh\necho 'a.cpp:1: error: so wrong'\nexit 1\n")
        run = self.door()
        self.assertEqual(run.returncode, 70)
        self.assertIn("so wrong", run.stderr)
        self.assertEqual(run.stdout, "")

    def test_works_through_a_symbolic_link_from_another_folder(self):
        link = Path(self.folder.name) / "link"
        link.symlink_to(self.root / "kiri")
        run = subprocess.run([link, "x"], env=self.environment(), capture_output=True, text=True, cwd="/", timeout=60)
        self.assertEqual((run.stdout, run.returncode), ("built: x\n", 5), run.stderr)


if __name__ == "__main__":
    unittest.main()
