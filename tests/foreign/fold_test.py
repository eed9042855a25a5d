#!/usr/bin/env python3
# FOLD files that the program writes, read by the `fold` package of the format's authors.
# SPDX-License-Identifier: MIT
"""Skipped with a printed reason (exit code 77) where the package cannot be had; fails then when CI is set."""

import json
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

from npm_packages import HERE, PROGRAM, ROOT, installed_or_exit


def turned(length, degrees):
    return (length * math.cos(math.radians(degrees)), length * math.sin(math.radians(degrees)))


AXES = [(1, 0), (0, 1), (-1, 0), (0, -1)]


def square_twist():
    """A square twist, whose four pleats lie over each other in a ring; x, y, and letters as in .cp."""
    border = [(1, -100, -100, 100, -100), (1, 100, -100, 100, 100), (1, 100, 100, -100, 100), (1, -100, 100, -100, -100)]
    lines = []
    # A small square turned by 60 degrees; from each corner two parallel creases run to the border.
    side = 40
    corners = [turned(side / math.sqrt(2), 45 + 60 + 90 * k) for k in range(4)]
    for k in range(4):
        x, y = corners[k]
        u, v = corners[(k + 1) % 4]
        lines.append((3, x, y, u, v))
        for letter, (dx, dy) in ((3, AXES[(k + 1) % 4]), (2, AXES[k])):
            lines.append((letter, x, y, 100 * dx if dx else x, 100 * dy if dy else y))
    return "".join(" ".join(repr(float(n)) if i else str(n) for i, n in enumerate(line)) + "\n" for line in border + lines)


def map_of(columns, rows, letter):
    """A map of unit squares as FOLD."""
    index = {(x, y): y * (columns + 1) + x for y in range(rows + 1) for x in range(columns + 1)}
    edges = [((x, y), (x + 1, y), "B" if y in (0, rows) else letter) for y in range(rows + 1) for x in range(columns)]
    edges += [((x, y), (x, y + 1), "B" if x in (0, columns) else letter) for x in range(columns + 1) for y in range(rows)]
    return json.dumps({"file_spec": 1.1, "frame_unit": "cm", "vertices_coords": [list(p) for p in index],
                       "edges_vertices": [[index[a], index[b]] for a, b, _ in edges],
                       "edges_assignment": [kind for _, _, kind in edges]})


class Fold(unittest.TestCase):
    packages = None

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def put(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def kiri(self, *arguments):
        run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def reports(self, *files):
        run = subprocess.run(["node", HERE / "read_fold.mjs", self.packages, *files], capture_output=True, text=True,
                             timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("Confusion", run.stderr)
        return [json.loads(run.stdout)[str(file)] for file in files]

    def check_pattern(self, file, report):
        """Everything that the package rebuilds is what the file says."""
        self.assertTrue(report["text"], file)
        self.assertEqual({k: v for k, v in report["rebuilt"].items() if k != "edges"},
                         {"faces": True, "edges_faces": True, "faces_edges": True}, file)
        self.assertEqual(report["rebuilt"]["edges"], report["edges"], file)
        self.assertEqual(report["cleaned"], {"vertices": report["vertices"], "edges": report["edges"]}, file)

    def check_states(self, file, report):
        """Folded forms are those of the package, and each fold says how its two faces lie."""
        for frame in report["frames"]:
            self.assertEqual(frame["classes"], ["foldedForm"], file)
            self.assertLess(frame["folding"]["error"], 1e-9 * report["size"], file)
            self.assertLess(frame["folding"]["apart"], 1e-9 * report["size"], file)
            sides = {}
            for f, g, side in frame["orders"]:
                self.assertIn(side, (1, -1))
                self.assertTrue(0 <= f < report["faces"] and 0 <= g < report["faces"] and f != g, file)
                self.assertNotIn((min(f, g), max(f, g)), sides, file)
                sides[(min(f, g), max(f, g))] = side
            folds = 0
            for (left, right), letter in zip(frame["edges_faces"], frame["assignments"]):
                if left is None or right is None:
                    continue
                self.assertIn(letter, "MV", file)
                self.assertEqual(sides[(min(left, right), max(left, right))], 1 if letter == "V" else -1, file)
                folds += 1
            self.assertGreater(folds, 0)

    def test_states_of_patterns_are_read_as_they_are(self):
        patterns = [(self.put("twist.cp", square_twist()), 1), (self.put("map.fold", map_of(3, 2, "U")), 60),
                    (self.put("strip.fold", map_of(4, 1, "U")), 16)]
        for pattern, count in patterns:
            out = self.folder / (pattern.stem + "_states.fold")
            self.assertEqual(self.kiri("states", pattern, "--count").strip(), str(count))
            self.kiri("states", pattern, "--all", "-o", out)
            [report] = self.reports(out)
            self.check_pattern(out, report)
            self.assertEqual(len(report["frames"]), count)
            self.check_states(out, report)
            self.assertEqual(len({json.dumps(frame["orders"]) for frame in report["frames"]}), count)

    def test_a_ring_of_layers_is_in_the_orders(self):
        out = self.folder / "twist.fold"
        self.kiri("states", self.put("twist.cp", square_twist()), "-o", out)
        file = json.loads(out.read_text())
        above = {}
        for f, g, side in file["file_frames"][0]["faceOrders"]:
            loop = [file["file_frames"][0]["vertices_coords"][v] for v in file["faces_vertices"][g]]
            area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(loop, loop[1:] + loop[:1]))
            upper, lower = (f, g) if (side == 1) == (area > 0) else (g, f)
            above.setdefault(lower, set()).add(upper)
        # No list holds these orders: taking away what nothing lies on ends before all are gone.
        left = set(range(len(file["faces_vertices"])))
        while True:
            free = {face for face in left if not above.get(face, set()) & left}
            if not free:
                break
            left -= free
        self.assertGreaterEqual(len(left), 3)

    def test_patterns_and_models_are_read_as_they_are(self):
        twist = self.put("twist.cp", square_twist())
        files = []
        for name, source in (("pattern", twist), ("map", self.put("map.fold", map_of(3, 2, "V")))):
            self.kiri("convert", source, self.folder / f"{name}.kiri", "--flat")
            self.kiri("convert", self.folder / f"{name}.kiri", self.folder / f"{name}_again.fold")
            files.append(self.folder / f"{name}_again.fold")
        for model in ("ship", "leaf_palmate"):
            self.kiri("export", ROOT / f"examples/{model}.kiri", "--view", "pattern", "--as-folded", "-o",
                      self.folder / f"{model}.fold")
            files.append(self.folder / f"{model}.fold")
        for file, report in zip(files, self.reports(*files)):
            self.assertGreater(report["faces"], 1, file)
            self.assertTrue(report["text"], file)
            self.assertEqual(report["rebuilt"]["edges"], report["edges"], file)

    def test_the_package_would_find_a_wrong_file(self):
        out = self.folder / "map.fold"
        self.kiri("states", self.put("m.fold", map_of(3, 2, "U")), "-o", out)
        file = json.loads(out.read_text())
        file["edges_faces"][0] = [None, None]
        file["file_frames"][0]["vertices_coords"][0][0] += 0.25
        [report] = self.reports(self.put("bad.fold", json.dumps(file)))
        self.assertFalse(report["rebuilt"]["edges_faces"])
        self.assertGreater(report["frames"][0]["folding"]["apart"], 0.1)


if __name__ == "__main__":
    Fold.packages = installed_or_exit()
    unittest.main()
