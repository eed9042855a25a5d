#!/usr/bin/env python3
# Plants one violation of each rule in a small tree and sees that the checker finds it.
# SPDX-License-Identifier: MIT

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import check_architecture  # noqa: E402

TABLE = """
| target | may use | packages | must never mention |
| --- | --- | --- | --- |
| `core/base` | | | Qt, GL, files, clock, threads, random |
| `core/paper` | `core/base` | | Qt, GL, files, clock, threads, random |
| `io` | `core` | `nlohmann_json` | Qt, GL, clock |
| `render/canvas` | `core/base` | `cairo` | Qt |
"""
HEAD = "// What it is for.\n// SPDX-License-Identifier: MIT\n"
GOOD = {
    "ARCHITECTURE.md": TABLE,
    "core/base/vec.h": HEAD + '#pragma once\n#include <cmath>\n// about 1e-9, no std::cout here\n',
    "core/paper/sheet.h": HEAD + '#pragma once\n#include "core/base/vec.h"\n',
    "core/paper/sheet.cpp": HEAD + '#include "core/paper/sheet.h"\nconst char* s = "1e-9 TODAY \\" //";\n'
                                   "int big = 1'000'000; char c = '\"'; /* QWidget 1e-3 */\n",
    "io/read.cpp": HEAD + '#include <unistd.h>\n#include <fstream>\n#include <nlohmann/json.hpp>\n',
    "render/canvas/png.cpp": HEAD + "#include <cairo.h>\n",
}


def problems_with(**changes):
    """Violations in the good tree after writing (or with None, removing) the given files."""
    files = {**GOOD, **{name: text for name, text in changes.get("files", {}).items()}}
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in files.items():
            if text is not None:
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
        return check_architecture.check(root)


class Checker(unittest.TestCase):
    def finds(self, name, text, *words):
        problems = problems_with(files={name: text})
        self.assertEqual(len(problems), 1, problems)
        for word in words:
            self.assertIn(word, problems[0])

    def adds(self, name, line, *words):
        self.finds(name, GOOD[name] + line + "\n", f"{name}:", *words)

    def test_accepts_a_tree_that_keeps_the_rules(self):
        self.assertEqual(problems_with(), [])

    def test_finds_an_upward_include(self):
        self.adds("core/base/vec.h", '#include "core/paper/sheet.h"', "core/base may not use core/paper")

    def test_finds_an_include_the_table_does_not_name(self):
        self.adds("render/canvas/png.cpp", '#include "core/paper/sheet.h"', "may not use core/paper")

    def test_finds_an_include_that_is_not_from_the_root(self):
        self.adds("core/paper/sheet.cpp", '#include "sheet.h"', "root of the repository")

    def test_finds_an_include_of_a_missing_file(self):
        self.adds("core/paper/sheet.cpp", '#include "core/base/gone.h"', "does not exist")

    def test_finds_a_package_out_of_its_room(self):
        self.adds("io/read.cpp", "#include <cairo-pdf.h>", "may not use the package cairo")
        self.adds("core/paper/sheet.cpp", "#include <nlohmann/json.hpp>", "nlohmann_json")

    def test_finds_a_header_nobody_declared(self):
        self.adds("io/read.cpp", "#include <tbb/tbb.h>", "neither")

    def test_finds_every_forbidden_word(self):
        samples = {"Qt": "QString name;", "GL": "void f() { glClear(1); }", "files": "#include <iostream>",
                   "clock": "#include <chrono>", "threads": "#include <thread>", "random": "int r = rand();"}
        self.assertEqual(set(samples), set(check_architecture.FORBIDDEN))
        for word, line in samples.items():
            self.adds("core/paper/sheet.cpp", line, f"must not mention {word}")

    def test_finds_a_bare_tolerance(self):
        for literal in ("1e-9", "1.5E-6", "2.e-3"):
            self.adds("io/read.cpp", f"double eps = {literal};", "tolerance.h")

    def test_allows_tolerances_where_they_live(self):
        files = {"ARCHITECTURE.md": TABLE + "| `core/geometry` | | | |\n",
                 "core/geometry/tolerance.h": HEAD + "#pragma once\ndouble eps = 1e-9;\n"}
        self.assertEqual(problems_with(files=files), [])

    def test_finds_a_folder_without_a_row(self):
        self.finds("core/cut/tear.cpp", HEAD, "core/cut", "no row")

    def test_finds_a_row_without_a_folder(self):
        self.finds("ARCHITECTURE.md", TABLE + "| `core/cut` | `core/base` | | |\n", "core/cut", "no folder")

    def test_finds_a_row_that_uses_a_later_row(self):
        text = TABLE.replace("| `core/paper` | `core/base` |", "| `core/paper` | `core/base`, `io` |")
        self.finds("ARCHITECTURE.md", text, "core/paper uses io")

    def test_finds_words_it_does_not_know(self):
        self.finds("ARCHITECTURE.md", TABLE.replace("GL, clock", "GL, clock, weather"), "weather")

    def test_finds_a_missing_table(self):
        self.assertTrue(problems_with(files={"ARCHITECTURE.md": "nothing"}))
        self.assertTrue(problems_with(files={"ARCHITECTURE.md": None}))

    def test_finds_a_file_that_is_too_long(self):
        self.finds("io/read.cpp", GOOD["io/read.cpp"] + "\n" * 500, "lines")

    def test_finds_a_missing_licence_line_and_guard(self):
        self.finds("core/paper/sheet.cpp", '#include "core/paper/sheet.h"\n', "SPDX")
        self.finds("core/paper/sheet.h", HEAD, "#pragma once")

    def test_finds_a_source_that_does_not_begin_with_its_header(self):
        text = HEAD + '#include "core/base/vec.h"\n#include "core/paper/sheet.h"\n'
        self.finds("core/paper/sheet.cpp", text, "first include")

    def test_finds_a_cast_between_object_types(self):
        self.adds("io/read.cpp", "auto p = reinterpret_cast<Vec2*>(q);", "cast")
        self.assertEqual(problems_with(files={"io/read.cpp": HEAD + "auto p = reinterpret_cast<const char*>(q);"}), [])

    def test_finds_unfinished_work(self):
        self.adds("io/read.cpp", "// TO" + "DO: later", "issue")

    def test_finds_names_that_clash_when_a_folder_is_compiled_together(self):
        def second(inside, first="io/read.cpp", name="io/read_more.cpp"):
            outer = "namespace kiri {{\nnamespace {{\n{}\n}}\n}}\n"
            one = ("constexpr int kMost = 3;\nconst char* const kWords[] = {\"a\", \"b\"};\nstruct Line { int kInside = 1; };\n"
                   "template <class T>\nT first(const T& line, int n = 2) { const int kLocal = n; return line + kLocal; }\n"
                   "int declared(int n);")
            return problems_with(files={first: HEAD + outer.format(one), name: HEAD + outer.format(inside)})

        for clash in ("constexpr double kMost = 1;", "const int kWords[2] = {1, 2};", "enum class Line { A };",
                      "struct Line { int a; };", "template <class T>\nT first(const T& other, int) { return other; }"):
            problems = second(clash)
            self.assertEqual(len(problems), 1, clash)
            self.assertIn("io/read_more.cpp:5: ", problems[0])
            self.assertIn("is also in io/read.cpp", problems[0])
        for free in ("constexpr int kLeast = 3;", "int first(double line) { return 1; }", "struct Line;",
                     "int declared(int n);", "void other() { int kMost = 1; }", "// constexpr int kMost = 1;"):
            self.assertEqual(second(free), [], free)
        self.assertEqual(second("constexpr int kMost = 3;", "core/paper/a.cpp"), [])
        self.assertEqual(len(second("constexpr int kMost = 3;", "tests/io/a.cpp", "tests/io/b.cpp")), 1)

    def test_finds_flags_that_change_results(self):
        self.finds("cmake/Fast.cmake", "add_compile_options(-march=native)\n", "Fast.cmake:1")


if __name__ == "__main__":
    unittest.main()
