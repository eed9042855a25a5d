# Names that sources of one folder keep to themselves, and that clash when the sources are compiled together.
# SPDX-License-Identifier: MIT
"""The sanitized build and the linter compile several sources of a folder as one. A constant, a class or a function
with the same parameters then may stand in the unnamed namespace of one source only."""

import re

OPENING = re.compile(r"\bnamespace\s*([\w:]*)\s*\{")
KEYWORDS = {"if", "for", "while", "switch", "return", "sizeof", "decltype", "alignas", "requires", "noexcept"}
TYPE = re.compile(r"(?:template\s*<[^{]*>\s*)?(?:struct|class|union|enum(?:\s+class)?)\s+(\w+)[^()=]*$", re.S)
VARIABLE = re.compile(r"(?:constexpr|const|inline|static|thread_local)\b[^=]*?(\w+)\s*(?:\[[^\]]*\]\s*)*(?:=.*)?$", re.S)
FUNCTION = re.compile(r"(?<![\w:~])(\w+)\s*(\((?:[^()]|\([^()]*\))*\))\s*(?:const|noexcept|->[^()]*|\s)*$", re.S)


def closing(text, start):
    """Where the brace that opens at `start` ends."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return len(text)


def statements(text, start, end):
    """The heads of what is declared directly between two places: (where, head, whether a body follows)."""
    head_at, parentheses, i = start, 0, start
    while i < end:
        parentheses += {"(": 1, ")": -1}.get(text[i], 0)
        if text[i] == "{" and parentheses == 0:
            head = text[head_at:i]
            yield head_at + len(head) - len(head.lstrip()), head.strip(), True
            i = closing(text, i)
            head_at = i + 1
        elif text[i] == ";" and parentheses == 0:
            head = text[head_at:i]
            yield head_at + len(head) - len(head.lstrip()), head.strip(), False
            head_at = i + 1
        i += 1


def parameter_types(text):
    """`(const Vec2& a, int n = 3)` as `const Vec2&,int`."""
    types = []
    depth, part = 0, ""
    for c in text[1:-1] + ",":
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(c, 0)
        if c == "," and depth == 0:
            part = re.sub(r"\s*=.*$", "", part, flags=re.S)
            types.append(" ".join(re.sub(r"(?<=[\s&*>])\w+$", "", part.strip()).split()))
            part = ""
        else:
            part += c
    return ",".join(types)


def name_of(head, has_body):
    """What a declaration defines, as it clashes; None for what may stand several times."""
    kind = TYPE.match(head)
    if kind:
        return kind[1] if has_body else None
    function = FUNCTION.search(head)
    if function:
        is_definition = has_body and not function[1].isupper() and function[1] not in KEYWORDS
        return function[1] + f"({parameter_types(function[2])})" if is_definition else None
    variable = VARIABLE.match(head)
    return variable[1] if variable else None


def unnamed_names(text, start=0, end=None, outer=""):
    """(enclosing namespace, name, where) of all that the unnamed namespaces of a source define; comments and literals
    are blanked already."""
    end = len(text) if end is None else end
    for space in OPENING.finditer(text, start, end):
        if space.start() < start:
            continue
        last = closing(text, space.end() - 1)
        start = last
        if space[1]:
            yield from unnamed_names(text, space.end(), last, outer + "::" + space[1])
            continue
        for where, head, has_body in statements(text, space.end(), last):
            name = name_of(re.sub(r"^\s*#.*$", "", head, flags=re.M).strip(), has_body)
            if name:
                yield outer, name, where


def clashes(sources):
    """One sentence for each name that two sources of a folder define: sources are (where, blanked text)."""
    first = {}
    for where, text in sources:
        for outer, name, at in unnamed_names(text):
            other = first.setdefault((outer, name), where)
            if other != where:
                yield f"{where}:{text.count(chr(10), 0, at) + 1}: {name} is also in {other}, with which it is compiled"
