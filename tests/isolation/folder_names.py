#!/usr/bin/env python3
"""Checks that names in unnamed namespaces are unique within a folder, and that no constant has the name of a constant
in a header. The release build compiles all sources of a folder as one, so such a name would silently hide another one.
   folder_names.py SOURCE_ROOT      prints every violation and fails if there is one
   folder_names.py --self-test      makes one violation of each kind and fails if the check misses one"""
import collections
import pathlib
import re
import sys
import tempfile

FOLDERS = ("framework", "passes", "viewer", "tests")
# Overloads of this function of GoogleTest may stand side by side; main() stands in GLSL texts.
SHARED = {"PrintTo", "main"}
FUNCTION = re.compile(r"^(?:\[\[nodiscard\]\] )?(?:constexpr |inline )*[\w:<>,&*\s]*[\w>][\s&*]+(\w+)\(")
TYPE = re.compile(r"^(?:struct|class|enum class|enum) (\w+)")
CONSTANT = re.compile(r"^(?:inline )?constexpr [^=(<{]*?(?:<[^;=]*>[^=({]*?)?\b(k[A-Z]\w*)\b(?=\s*[={;\[])")


def unnamed_names(text):
    inside = False
    for line in text.splitlines():
        if line == "namespace {":
            inside = True
        elif line == "}  // namespace" or line == "}" and not inside:
            inside = False
        elif inside and (line[:1].isalpha() or line[:1] == "[") and not line.startswith("using "):
            for pattern in (TYPE, CONSTANT, FUNCTION):
                found = pattern.match(line)
                if found and found.group(1) not in SHARED:
                    yield found.group(1)
                    break


def namespaces(text):
    """Yields each line of the text together with the namespace that contains the line."""
    stack = []
    for line in text.splitlines():
        opened = re.match(r"^namespace ([\w:]+) \{$", line)
        if opened:
            stack.append(opened.group(1))
        elif stack and line == "}  // namespace " + stack[-1]:
            stack.pop()
        yield line, "::".join(stack)


def breaches(root):
    # Maps the name of each constant in a header to its namespaces, and each namespace to the header.
    in_headers = collections.defaultdict(dict)
    files = [file for top in FOLDERS for file in sorted((root / top).rglob("*"))]
    for file in files:
        if file.suffix == ".h":
            for line, namespace in namespaces(file.read_text()):
                constant = CONSTANT.match(line)
                if constant:
                    in_headers[constant.group(1)][namespace] = file.relative_to(root).as_posix()
    owners = collections.defaultdict(set)
    hidden = []
    for file in files:
        if file.suffix == ".cpp":
            text, source = file.read_text(), file.relative_to(root).as_posix()
            own = max((namespace for _, namespace in namespaces(text)), key=len, default="")
            for name in unnamed_names(text):
                owners[file.parent, name].add(source)
                for namespace, header in in_headers[name].items():
                    if (own + "::").startswith(namespace + "::"):
                        hidden.append(f"{name} in {source} is named like a constant of {header}")
    found = hidden
    for (_, name), sources in sorted(owners.items()):
        if len(sources) > 1:
            found.append(f"{name} is in unnamed namespaces of several sources of one folder: " + ", ".join(sorted(sources)))
    return found


def self_test():
    planted = {
        "a/one.cpp": "namespace weft::x {\nnamespace {\nint twice(int x) {\n}\nstruct Both {\n};\nconstexpr int kHidden = 1;\n}  // namespace\n}  // namespace weft::x\n",
        "a/two.cpp": "namespace {\n[[nodiscard]] int twice(float x) {\n}\nclass Both {\n};\n}  // namespace\n",
        "b/far.cpp": "namespace {\nint twice(int x) {\n}\n}  // namespace\nint open(int x) {\n}\n",
        "b/near.cpp": "int open(float x) {\n}\n",
        "b/names.h": "namespace weft {\ninline constexpr int kHidden = 2;\n}  // namespace weft\n",
        "b/others.h": "namespace weft::y {\ninline constexpr int kHidden = 2;\n}  // namespace weft::y\n",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for top in FOLDERS:
            (root / top).mkdir()
        for path, text in planted.items():
            (root / "framework" / path).parent.mkdir(exist_ok=True)
            (root / "framework" / path).write_text(text)
        found = breaches(root)
    if sorted(line.split()[0] for line in found) != ["Both", "kHidden", "twice"]:
        sys.exit("\n".join(["three breaches were planted, and these were found:"] + found))


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    lines = breaches(pathlib.Path(sys.argv[1]))
    print("\n".join(lines) if lines else "names are unique within each folder")
    sys.exit(1 if lines else 0)
