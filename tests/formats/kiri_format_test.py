#!/usr/bin/env python3
# The model format has three descriptions: the reader, the JSON Schema, and docs/formats/kiri.md. They must agree.
# SPDX-License-Identifier: MIT
"""Holds examples, documented examples, mistakes and random damages against schema and reader."""
import copy
import glob
import json
import os
import random
import re
import subprocess
import sys
import unittest

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: skipped (./test installs it)")
    sys.exit(0)

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("KIRI_PROGRAM")
SEED = 20240611
CASES = 300

with open(os.path.join(ROOT, "docs/formats/kiri.schema.json"), encoding="utf-8") as file:
    SCHEMA = json.load(file)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def wrapped(steps, sheet=None):
    return {"format": "kiri", "version": 1, "sheet": sheet or {"shape": "square", "side": 150}, "steps": steps}


def reader_accepts(document):
    """Whether the program reads the document, and what it says. Only the sheet is made, no step is applied."""
    result = subprocess.run([PROGRAM, "info", "-", "--step", "0"], input=json.dumps(document), text=True,
                            capture_output=True, check=False)
    # A polygon may be fine as a file and impossible as a sheet: only sentences with line and column are the reader's.
    is_read = result.returncode == 0 or not re.match(r"error: standard input:\d+:\d+: ", result.stderr)
    return is_read, result.stderr


def documented():
    """Every example of docs/formats/kiri.md, made into a whole file."""
    with open(os.path.join(ROOT, "docs/formats/kiri.md"), encoding="utf-8") as text:
        blocks = re.findall(r"```json\n(.*?)```", text.read(), re.S)
    for block in blocks:
        part = json.loads(block)
        if "do" in part:
            yield wrapped([part])
        elif "format" in part:
            yield part
        else:
            yield {**wrapped([]), **part}


LINE = {"paper": [[1, 2], [3, 4]]}
FOLD = {"do": "fold", "line": LINE, "type": "valley", "move": "left"}
MISTAKES = [
    {},
    [],
    {**wrapped([]), "format": "fold"},
    {**wrapped([]), "version": 2},
    {**wrapped([]), "title": 3},
    {**wrapped([]), "paper": {"front": {"color": "green"}}},
    wrapped([], {"shape": "square"}),
    wrapped([], {"shape": "square", "side": 0}),
    wrapped([], {"shape": "square", "side": 5, "width": 5}),
    wrapped([], {"shape": "blob", "side": 5}),
    wrapped([], {"shape": "polygon", "outline": [[0, 0], [1, 0]]}),
    wrapped([{}]),
    wrapped([{"do": "foldd"}]),
    wrapped([{**FOLD, "angle": 200}]),
    wrapped([{**FOLD, "type": "up"}]),
    wrapped([{**FOLD, "move": "up"}]),
    wrapped([{**FOLD, "line": [[1, 2], [3, 4]]}]),
    wrapped([{**FOLD, "line": {"paper": [[1, 2], [1, 2]]}}]),
    wrapped([{**FOLD, "line": {"paper": [[1, 2], [3, 4], [5, 6]]}}]),
    wrapped([{**FOLD, "line": {"model": [[1, 2], [3, 4]], "facet": [1, 1]}}]),
    wrapped([{**FOLD, "layers": {"top": 0}}]),
    wrapped([{**FOLD, "layers": {"top": 1.5}}]),
    wrapped([{**FOLD, "layers": {"top": 1, "facets": [[1, 1]]}}]),
    wrapped([{**FOLD, "move": {"facets": []}}]),
    wrapped([{"do": "angle", "fold": "a", "angle": 181}]),
    wrapped([{"do": "angle", "fold": "", "angle": 1}]),
    wrapped([{"do": "unfold", "folds": []}]),
    wrapped([{"do": "unfold", "sequence": "at once"}]),
    wrapped([{"do": "tear", "path": {"paper": [[1, 2]]}}]),
    wrapped([{"do": "straight cut", "line": LINE}]),
    wrapped([{"do": "straight cut", "line": LINE, "keep": []}]),
    wrapped([{"do": "curve cut", "curve": {"model": [[0, 0], [1, 1], [2, 2]]}, "keep": "all"}]),
    wrapped([{"do": "turn over", "axis": "x"}]),
    wrapped([{"do": "rotate"}]),
    wrapped([{"do": "move", "by": [1, 2, 3]}]),
]

SEEDS = [
    wrapped([FOLD, {**FOLD, "name": "b", "angle": 90, "layers": {"top": 2}, "move": {"point": {"model": [1, 2]}}}]),
    wrapped([{**FOLD, "layers": {"facets": [[1, 1], {"paper": [2, 2]}]}, "move": {"facets": [[3, 3]]}}]),
    wrapped([{"do": "angle", "fold": {"paper": [1, 2]}, "angle": -90}, {"do": "unfold", "folds": ["a", [1, 2]]}]),
    wrapped([{"do": "refold", "sequence": "together"}, {"do": "mend", "path": "all"}]),
    wrapped([{"do": "tear", "path": {"model": [[1, 2], [3, 4]]}, "layers": {"top": 1}}]),
    wrapped([{"do": "straight cut", "line": {"model": [[0, 1], [1, 1]]}, "keep": [[1, 1], {"paper": [1, 2]}]}]),
    wrapped([{"do": "curve cut", "curve": {"paper": [[0, 0], [1, 1], [2, 0]], "facet": [1, 1], "closed": True},
              "keep": "all"}]),
    wrapped([{"do": "rotate", "degrees": 30, "about": [1, 1]}, {"do": "move", "by": [1, 1]}]),
    wrapped([], {"shape": "polygon", "outline": [[0, 0], [9, 0], [0, 9]], "holes": [[[1, 1], [2, 1], [1, 2]]]}),
    {**wrapped([], {"shape": "disc", "diameter": 9}), "paper": {"front": {"color": "#fff", "texture": "a.png"}}},
]

VALUES = [None, True, False, 0, 1, -1, 2, 0.5, 181, 2000000, "", "all", "left", "valley", "fold", [], {}, [1, 2],
          [[1, 2]], [[1, 2], [3, 4]], {"paper": [1, 2]}, {"model": [[1, 2], [3, 4]]}, {"top": 1}]


def holders(value):
    """Every object and list in a document."""
    if isinstance(value, (dict, list)):
        yield value
        for part in value.values() if isinstance(value, dict) else value:
            yield from holders(part)


def damaged(document, source):
    """The document with one field dropped, added or replaced."""
    document = copy.deepcopy(document)
    holder = source.choice([h for h in holders(document) if h])
    key = source.choice(list(holder)) if isinstance(holder, dict) else source.randrange(len(holder))
    kind = source.randrange(4)
    if kind == 0:
        del holder[key]
    elif kind == 1 and isinstance(holder, list):
        holder.append(copy.deepcopy(holder[key]))
    elif kind == 1:
        holder[source.choice(["facet", "top", "model", "paper", "closed", "side", "extra"])] = source.choice(VALUES)
    else:
        holder[key] = copy.deepcopy(source.choice(VALUES))
    return document


def has_equal_fold_names(document):
    """What a schema cannot see."""
    steps = document.get("steps") if isinstance(document, dict) else None
    names = []
    for number, step in enumerate(steps if isinstance(steps, list) else [], 1):
        if isinstance(step, dict) and step.get("do") == "fold":
            names.append(step.get("name") or "fold %d" % number)
    texts = [name for name in names if isinstance(name, str)]
    return len(texts) != len(set(texts))


class KiriFormat(unittest.TestCase):
    def test_the_schema_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_every_example_file_follows_the_schema(self):
        paths = sorted(glob.glob(os.path.join(ROOT, "examples", "**", "*.kiri"), recursive=True))
        self.assertTrue(paths)
        for path in paths:
            with self.subTest(path=os.path.relpath(path, ROOT)), open(path, encoding="utf-8") as text:
                VALIDATOR.validate(json.load(text))

    def test_every_documented_example_follows_the_schema_and_is_read(self):
        examples = list(documented())
        self.assertGreater(len(examples), 12)
        for example in examples:
            with self.subTest(example=example):
                VALIDATOR.validate(example)
                if PROGRAM:
                    self.assertEqual(reader_accepts(example), (True, ""))

    def test_every_step_is_documented_with_an_example(self):
        kinds = set(SCHEMA["definitions"]["step"]["properties"]["do"]["enum"])
        shown = {step["do"] for example in documented() for step in example["steps"]}
        self.assertEqual(shown, kinds)

    def test_mistakes_fail_the_schema_and_the_reader(self):
        for mistake in MISTAKES:
            with self.subTest(mistake=mistake):
                self.assertFalse(VALIDATOR.is_valid(mistake))
                if PROGRAM:
                    self.assertFalse(reader_accepts(mistake)[0])

    @unittest.skipUnless(PROGRAM, "the program is not built")
    def test_schema_and_reader_agree_on_random_damages(self):
        source = random.Random(SEED)
        valid = 0
        for case in range(CASES):
            document = damaged(source.choice(SEEDS), source)
            is_valid = VALIDATOR.is_valid(document) and not has_equal_fold_names(document)
            is_read, sentence = reader_accepts(document)
            self.assertEqual(is_valid, is_read, "case %d: %s\n%s" % (case, json.dumps(document), sentence))
            valid += is_valid
        self.assertGreater(valid, CASES // 20)
        self.assertLess(valid, CASES)


if __name__ == "__main__":
    unittest.main()
