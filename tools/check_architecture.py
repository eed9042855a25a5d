#!/usr/bin/env python3
# Holds the tree against the table of layers in ARCHITECTURE.md and the rules that a compiler cannot check.
# SPDX-License-Identifier: MIT
"""Usage: check_architecture.py [ROOT]. Prints one line for each violation; exit code 1 when there is one."""

import re
import sys
from pathlib import Path

from room_names import clashes

TOPS = ("core", "io", "render", "editor", "apps")
CODE = (".h", ".cpp")
MAX_LINES = 500
TOLERANCE_FILES = ("core/geometry/tolerance.h", "core/geometry/tolerance.cpp")

# What the words of the table's last column mean in code.
FORBIDDEN = {
    "Qt": r"\bQ[A-Z][A-Za-z]+\b|#\s*include\s*<Q",
    "GL": r"\bgl(?!TF)[A-Z]\w*\(|\bGL_[A-Z]|\bGL(?:uint|int|float|enum|sizei)\b|#\s*include\s*<(?:GL|GLES|EGL)",
    "files": r"#\s*include\s*<(?:fstream|filesystem|iostream)>|\bstd::(?:cout|cerr|cin|filesystem)\b"
             r"|\b(?:fopen|fprintf|printf|puts)\s*\(|\bFILE\s*\*",
    "clock": r"#\s*include\s*<(?:chrono|ctime)>|\bstd::chrono\b|\bclock_gettime\b|\bclock\s*\(\s*\)",
    "threads": r"#\s*include\s*<(?:thread|mutex|shared_mutex|future|atomic|condition_variable)>"
               r"|\bstd::(?:thread|jthread|async|mutex|atomic)\b|\bpthread_",
    "random": r"#\s*include\s*<random>|\bs?rand\s*\(|\brandom_device\b|\bmt19937",
}

# Headers of packages from outside, by the name that the table's packages column uses.
PACKAGE_HEADERS = {
    "nlohmann_json": r"nlohmann/",
    "CLI11": r"CLI/",
    "Eigen3": r"Eigen/",
    "cadical": r"cadical\.hpp$",
    "boost": r"boost/",
    "pugixml": r"pugixml\.hpp$",
    "cairo": r"cairo",
    "libpng": r"png\.h$",
    "epoxy": r"epoxy/",
    "Qt6": r"Q[A-Z][A-Za-z]+$",
}
# Headers of the operating system: allowed where files are.
SYSTEM_HEADER = r"(?:unistd|fcntl|signal|spawn|termios|sys/\w+)\.h$"
STANDARD_HEADER = r"[a-z_0-9]+$"

RAW_TOLERANCE = re.compile(r"(?<![\w.])\d+(?:\.\d*)?[eE]-\d+")
UNFINISHED = re.compile(r"\b(?:TODO|FIXME|XXX)\b")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
ROW = re.compile(r"^\| `([a-z_/]+)` *\|([^|]*)\|([^|]*)\|([^|]*)\|")
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)


class Layer:
    def __init__(self, name, uses, packages, forbidden):
        self.name, self.uses, self.packages, self.forbidden = name, uses, packages, forbidden


def read_table(text):
    """The layers by name, bottom first, and what is wrong with the table itself."""
    layers, problems = {}, []
    for number, line in enumerate(text.splitlines(), 1):
        row = ROW.match(line)
        if not row:
            continue
        name = row[1]
        uses = set()
        for entry in re.findall(r"[\w/]+", row[2]):
            known = {other for other in layers if other == entry or other.startswith(entry + "/")}
            if not known:
                problems.append(f"ARCHITECTURE.md:{number}: {name} uses {entry}, which is no row above it")
            uses |= known
        packages = set(re.findall(r"\w+", row[3]))
        forbidden = set(re.findall(r"\w+", row[4]))
        for word in sorted(packages - set(PACKAGE_HEADERS)) + sorted(forbidden - set(FORBIDDEN)):
            problems.append(f"ARCHITECTURE.md:{number}: tools/check_architecture.py does not know {word}")
        layers[name] = Layer(name, uses, packages & set(PACKAGE_HEADERS), forbidden & set(FORBIDDEN))
    if not layers:
        problems.append("ARCHITECTURE.md: no table of layers found")
    return layers, problems


def without_comments(text):
    """The code with comments and the insides of literals blanked, lines kept, includes kept."""
    def blank(match):
        token = match[0]
        line = text.rfind("\n", 0, match.start()) + 1
        if token[0] == '"' and INCLUDE.match(text[line:match.end()]):
            return token
        return re.sub(r"[^\n]", " ", token)

    # A digit separator (1'000) is not the start of a character literal.
    return TOKEN.sub(blank, re.sub(r"(?<=\d)'(?=\d)", "_", text))


def code_files(root):
    for top in TOPS:
        if (root / top).is_dir():
            for path in sorted((root / top).rglob("*")):
                if path.suffix in CODE and path.is_file():
                    yield path


def check_folders(root, layers, files):
    folders = {path.parent.relative_to(root).as_posix() for path in files}
    for folder in sorted(folders - set(layers)):
        yield f"{folder}: holds code but is no row of the table in ARCHITECTURE.md"
    for name in layers:
        if name not in folders:
            yield f"ARCHITECTURE.md: the row {name} has no folder with code"


def check_include(root, layer, layers, bracket, target):
    if bracket == '"':
        folder = target.rpartition("/")[0]
        if folder not in layers:
            return f'"{target}" is not in a layer; includes are written from the root of the repository'
        if folder != layer.name and folder not in layer.uses:
            return f"{layer.name} may not use {folder}"
        if not (root / target).is_file():
            return f'"{target}" does not exist'
        return None
    for package, pattern in PACKAGE_HEADERS.items():
        if re.match(pattern, target):
            return None if package in layer.packages else f"{layer.name} may not use the package {package}"
    if re.match(STANDARD_HEADER, target):
        return None
    if re.match(SYSTEM_HEADER, target) and "files" not in layer.forbidden:
        return None
    return f"<{target}> is neither of the standard library nor of a package in the table"


def check_code(root, path, layer, layers):
    where = path.relative_to(root).as_posix()
    text = path.read_text(encoding="utf-8")
    lines = without_comments(text).splitlines()
    for number, line in enumerate(lines, 1):
        include = INCLUDE.match(line)
        if include:
            problem = check_include(root, layer, layers, include[1], include[2])
            if problem:
                yield f"{where}:{number}: {problem}"
        for word in sorted(layer.forbidden):
            if re.search(FORBIDDEN[word], line):
                yield f"{where}:{number}: {layer.name} must not mention {word}"
        if re.search(r"\breinterpret_cast<(?!(?:const )?(?:unsigned )?char\s*\*>)", line):
            yield f"{where}:{number}: a cast between object types, which no sanitizer looks into"
        if where not in TOLERANCE_FILES and RAW_TOLERANCE.search(line):
            yield f"{where}:{number}: a bare tolerance; name it in core/geometry/tolerance.h with its reason"


def check_first_include(root, path):
    """A source includes its own header first, which proves that the header compiles on its own."""
    header = path.with_suffix(".h")
    if path.suffix != ".cpp" or not header.is_file():
        return
    wanted = header.relative_to(root).as_posix()
    for line in path.read_text(encoding="utf-8").splitlines():
        include = INCLUDE.match(line)
        if include:
            if include[2] != wanted:
                yield f'{path.relative_to(root)}: the first include must be "{wanted}"'
            return


def check_text(root, path):
    where = path.relative_to(root).as_posix()
    lines = path.read_text(encoding="utf-8").splitlines()
    if len(lines) > MAX_LINES:
        yield f"{where}: {len(lines)} lines; a file has at most {MAX_LINES}"
    if not any("SPDX-License-Identifier: MIT" in line for line in lines[:3]):
        yield f"{where}: one of the first lines must read SPDX-License-Identifier: MIT"
    if path.suffix == ".h" and "#pragma once" not in lines:
        yield f"{where}: a header needs #pragma once"
    if path.name != Path(__file__).name:
        for number, line in enumerate(lines, 1):
            if UNFINISHED.search(line):
                yield f"{where}:{number}: unfinished work is written down in an issue, not in the code"


def check_names(root):
    """Sources of a folder are compiled together, those of tests too."""
    folders = {}
    for top in TOPS + ("tests", "benchmarks"):
        for path in sorted((root / top).rglob("*.cpp")) if (root / top).is_dir() else ():
            blanked = without_comments(path.read_text(encoding="utf-8"))
            folders.setdefault(path.parent, []).append((path.relative_to(root).as_posix(), blanked))
    for sources in folders.values():
        yield from clashes(sources)


def check_build_files(root):
    for path in sorted(root.glob("cmake/*.cmake")) + [root / "CMakeLists.txt", root / "CMakePresets.json"]:
        if path.is_file():
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if re.search(r"-ffast-math|-march=native|-Ofast|-ffp-contract=(?!off)", line):
                    yield f"{path.relative_to(root)}:{number}: a flag that changes results from build to build"


def check(root):
    """All violations in the tree below `root`, one sentence each."""
    table = root / "ARCHITECTURE.md"
    if not table.is_file():
        return ["ARCHITECTURE.md is missing"]
    layers, problems = read_table(table.read_text(encoding="utf-8"))
    files = list(code_files(root))
    problems += check_folders(root, layers, files)
    for path in files:
        layer = layers.get(path.parent.relative_to(root).as_posix())
        if layer:
            problems += check_code(root, path, layer, layers)
            problems += check_first_include(root, path)
    others = [p for top in ("tests", "benchmarks", "examples", "tools") if (root / top).is_dir()
              for p in sorted((root / top).rglob("*")) if p.suffix in CODE + (".py", ".sh")]
    for path in files + others:
        problems += check_text(root, path)
    problems += check_names(root)
    problems += check_build_files(root)
    return problems


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    problems = check(root.resolve())
    for problem in problems:
        print(problem)
    print(f"architecture: {len(problems)} violations" if problems else "architecture: all rules hold")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
