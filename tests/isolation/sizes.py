#!/usr/bin/env python3
"""Checks sizes: a folder has at most 45 sources, a file at most 400 lines, and a function at most 80 lines.
   sizes.py SOURCE_ROOT      prints every violation and fails if there is one
   sizes.py --self-test      makes one violation of each kind and fails if the check misses one"""
import collections
import pathlib
import re
import sys
import tempfile

MOST_SOURCES, MOST_LINES, MOST_FUNCTION_LINES = 45, 400, 80
SOURCES = {".h", ".cpp", ".py", ".sh"}
# These patterns rely on the format of the sources. A function of a namespace begins and ends in the first column; a
# function of a class begins and ends in the fifth column.
NO_FUNCTION = re.compile(r"\s*(if|for|while|switch|namespace|struct|class|enum|union|extern)\b")
ENDS_SOMETHING = re.compile(r"([;{}:]|^\s*(//|#).*|^\s*)$")


def signature_start(lines, index):
    """Returns the index of the line where the statement that ends at `index` begins."""
    while index > 0 and not ENDS_SOMETHING.search(lines[index - 1]):
        index -= 1
    return index


def functions(lines):
    """Yields the number of the first line and the number of lines of each function definition."""
    start, closing = None, ""
    for index, line in enumerate(lines):
        if start is not None:
            if line in (closing, closing + ";"):
                yield start + 1, index - start + 1
                start = None
        elif line.endswith("{") and ")" in line:
            first = signature_start(lines, index)
            indent = lines[first][: len(lines[first]) - len(lines[first].lstrip())]
            # The lambda is a part of a table, so its lines are not counted as a function.
            is_lambda = any("[](" in text for text in lines[first:index + 1])
            if len(indent) in (0, 4) and not is_lambda and not NO_FUNCTION.match(lines[first]):
                start, closing = first, indent + "}"


def breaches(root):
    found = []
    beside = collections.Counter()
    for top in ("framework", "passes", "viewer", "tests"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in SOURCES:
                continue
            name = file.relative_to(root).as_posix()
            beside[file.parent.relative_to(root).as_posix()] += 1
            lines = file.read_text().splitlines()
            if len(lines) > MOST_LINES:
                found.append(f"{name}: {len(lines)} lines, {MOST_LINES} at most")
            if file.suffix not in (".h", ".cpp"):
                continue
            for first, count in functions(lines):
                if count > MOST_FUNCTION_LINES:
                    found.append(f"{name}:{first}: a function of {count} lines, {MOST_FUNCTION_LINES} at most")
    found += [f"{folder}: {count} sources, {MOST_SOURCES} at most" for folder, count in sorted(beside.items())
              if count > MOST_SOURCES]
    return found


def self_test():
    long_body = "    step();\n" * MOST_FUNCTION_LINES
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for top in ("framework", "passes", "viewer/full", "tests"):
            (root / top).mkdir(parents=True)
        (root / "framework/file.cpp").write_text("int x;\n" * (MOST_LINES + 1))
        (root / "framework/function.cpp").write_text("void f(int x) {\n" + long_body + "}\n")
        (root / "framework/wrapped.cpp").write_text("void f(int x,\n        int y) {\n" + long_body + "}\n")
        (root / "framework/made.cpp").write_text(
            "class A {\n    A(int x)\n        : x_(x) {\n" + long_body + "    }\n};\n")
        (root / "framework/method.h").write_text("class A {\n    void f() const {\n" + long_body + "    }\n};\n")
        (root / "framework/good.cpp").write_text("namespace {\nvoid f() {\n    g();\n}\n" + "int y;\n" * 99 + "}\n")
        for number in range(MOST_SOURCES + 1):
            (root / f"viewer/full/{number}.h").write_text("")
        found = breaches(root)
    for guilty in ("framework/file.cpp", "framework/function.cpp", "framework/wrapped.cpp", "framework/made.cpp",
                   "framework/method.h", "viewer/full"):
        if not any(line.startswith(guilty + ":") for line in found):
            sys.exit(f"the breach in {guilty} was missed")
    if len(found) != 6:
        sys.exit("\n".join(["six breaches were planted, and these were found:"] + found))


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    lines = breaches(pathlib.Path(sys.argv[1]))
    print("\n".join(lines) if lines else "no folder, file or function is too large")
    sys.exit(1 if lines else 0)
