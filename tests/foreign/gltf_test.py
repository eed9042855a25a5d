#!/usr/bin/env python3
# glTF files that the program writes, judged by the validator of Khronos (npm package gltf-validator).
# SPDX-License-Identifier: MIT
"""Skipped with a printed reason (exit code 77) where the validator cannot be had; fails then when CI is set."""

import json
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

from npm_packages import HERE, PROGRAM, ROOT, installed_or_exit


def png(width, height, alpha):
    """A small image with a gradient."""
    def chunk(kind, content):
        body = kind + content
        return struct.pack(">I", len(content)) + body + struct.pack(">I", zlib.crc32(body))
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in (255 * x // width, 255 * y // height, 80, alpha))
                    for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def document_of(file):
    """The JSON of a GLB file, read without our own code."""
    data = file.read_bytes()
    magic, version, size = struct.unpack_from("<4sII", data)
    assert (magic, version, size) == (b"glTF", 2, len(data)), (magic, version, size, len(data))
    length, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    return json.loads(data[20:20 + length])


class Gltf(unittest.TestCase):
    validator = None

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, model, *options):
        out = self.folder / name
        run = subprocess.run([PROGRAM, "export", str(model), "-o", str(out), *options], capture_output=True, text=True,
                             timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        return out

    def reports(self, *files):
        run = subprocess.run(["node", HERE / "validate_gltf.mjs", self.validator, *files], capture_output=True,
                             text=True, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def check(self, *files):
        for file, report in self.reports(*files).items():
            issues = report["issues"]
            self.assertEqual(issues["numErrors"] + issues["numWarnings"], 0, (file, issues["messages"][:10]))

    def test_the_validator_finds_what_is_wrong(self):
        good = self.write("good.glb", ROOT / "examples/ship.kiri").read_bytes()
        bad = self.folder / "bad.glb"
        self.assertIn(b'"VEC3"', good)
        bad.write_bytes(good.replace(b'"VEC3"', b'"VEC9"'))
        self.assertGreater(self.reports(bad)[str(bad)]["issues"]["numErrors"], 0)

    def test_every_example_is_valid_as_surface_and_as_plates(self):
        files = []
        for model in sorted((ROOT / "examples").glob("*.kiri")):
            files.append(self.write(model.stem + ".glb", model))
            files.append(self.write(model.stem + "_plates.glb", model, "--thickness", "0.3"))
            files.append(self.write(model.stem + "_pattern.glb", model, "--view", "pattern"))
        self.assertGreater(len(files), 20)
        self.check(*files)

    def test_every_example_is_valid_in_motion(self):
        files = []
        for model in sorted((ROOT / "examples").glob("*.kiri")):
            files.append(self.write(model.stem + ".glb", model, "--animate"))
            files.append(self.write(model.stem + "_plates.glb", model, "--animate", "--thickness", "0.3", "--hold", "0",
                                    "--ease", "none"))
        self.check(*files)
        for file, report in self.reports(*files).items():
            self.assertEqual(report["info"]["animationCount"], 1, file)

    def test_textures_of_both_sides_are_in_the_file(self):
        (self.folder / "front.png").write_bytes(png(8, 8, 255))
        (self.folder / "back.png").write_bytes(png(4, 16, 100))
        model = json.loads((ROOT / "examples/ship.kiri").read_text())
        model["paper"] = {"front": {"color": "#aa2211", "texture": "front.png"},
                          "back": {"color": "#ddeeff", "texture": "back.png"}}
        textured = self.folder / "textured.kiri"
        textured.write_text(json.dumps(model))
        file = self.write("textured.glb", textured)
        self.check(file)
        document = document_of(file)
        self.assertEqual([image["mimeType"] for image in document["images"]], ["image/png"] * 2)
        for primitive in document["meshes"][0]["primitives"]:
            self.assertIn("TEXCOORD_0", primitive["attributes"])
        info = self.reports(file)[str(file)]["info"]
        self.assertEqual([(i["image"]["width"], i["image"]["height"]) for i in info["resources"] if "image" in i],
                         [(8, 8), (4, 16)])

    def test_sizes_are_metres(self):
        file = self.write("sheet.glb", ROOT / "examples/ship.kiri", "--step", "0")
        document = document_of(file)
        root = document["nodes"][document["scenes"][0]["nodes"][0]]
        self.assertEqual(root["scale"], [0.001, 0.001, 0.001])


if __name__ == "__main__":
    Gltf.validator = installed_or_exit()
    unittest.main()
