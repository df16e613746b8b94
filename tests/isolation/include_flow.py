#!/usr/bin/env python3
"""Checks that no include runs against the flow of data, and that public headers include only public headers.
   include_flow.py SOURCE_ROOT      prints every violation and fails if there is one
   include_flow.py --self-test      makes one violation of each kind and fails if the check misses one"""
import pathlib
import re
import sys
import tempfile

PUBLIC = "framework/include/weft"
# Folders in the order in which data flows through the program. A source may include headers of its own folder and of
# folders earlier in this list.
FLOW = [
    # Public headers with the types that the stages exchange.
    PUBLIC,
    "framework/graph/diagnostics", "framework/graph/model", "framework/graph/live", "framework/graph/syntax", "framework/graph/builder", "framework/graph/parse",
    "framework/graph/resolve", "framework/graph/plan", "framework/graph/cook", "framework/graph/rest", "framework/graph/schedule", "framework/graph/sync",
    "framework/graph/memory", "framework/graph/compile", "framework/graph/report", "framework/graph/report/html",
    "framework/check/faults", "framework/check/structure", "framework/check", "framework/null", "framework/file",
    "framework/shader/faults", "framework/shader/gate", "framework/shader/reflect", "framework/shader/worker",
    "framework/shader/compile", "framework/shader",
    "framework/scene/model", "framework/scene/loading", "framework/scene/pictures", "framework/scene/procedural",
    "framework/scene/builtin", "framework/scene/gltf", "framework/scene/export",
    "framework/scene/probes", "framework/image",
    "framework/load",
    "framework/vulkan/device", "framework/vulkan/memory", "framework/vulkan/pipelines", "framework/vulkan/record",
    "framework/vulkan/execute", "framework/render/views", "framework/render/motion", "framework/render/files",
    "framework/render", "passes",
    "viewer/files", "viewer/output", "viewer/process", "viewer/options", "viewer/pictures", "viewer/bench",
    "viewer/schema", "viewer/sandbox", "viewer/commands", "viewer",
]
# Some folders of public headers belong to a module. For the order of includes, such a folder counts as the folder given
# here.
PUBLIC_OWNERS = {
    "syntax": "framework/graph/syntax", "report": "framework/graph/report", "check": "framework/check",
    "shader": "framework/shader/faults", "load": "framework/load", "scene": "framework/scene/model",
    "image": "framework/image", "vulkan": "framework/vulkan/device", "render": "framework/render/views",
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)


def folder_of(path):
    """Returns the folder of FLOW that contains `path`, or None if no folder does."""
    parts = path.split("/")
    if path.startswith(PUBLIC + "/") and len(parts) > 4:
        return PUBLIC_OWNERS.get(parts[3])
    for length in range(len(parts) - 1, 0, -1):
        folder = "/".join(parts[:length])
        if folder in FLOW:
            return folder
    return None


def included_file(root, source, name):
    for base in (pathlib.PurePosixPath(source).parent.as_posix(), "framework/include", "framework", "passes", "."):
        candidate = (root / base / name)
        if candidate.is_file():
            return candidate.resolve().relative_to(root.resolve()).as_posix()
    return None


def breaches(root):
    found = []
    for top in ("framework", "passes", "viewer"):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            source = file.relative_to(root).as_posix()
            own = folder_of(source)
            if own is None:
                found.append(f"{source}: its folder has no place in the flow; add it to FLOW in include_flow.py")
                continue
            for name in INCLUDE.findall(file.read_text()):
                target = included_file(root, source, name)
                if target is None:
                    continue
                if target.startswith("tests/"):
                    found.append(f"{source}: includes {target}, a test")
                    continue
                if source.startswith(PUBLIC + "/") and not target.startswith(PUBLIC + "/"):
                    found.append(f"{source}: is public and includes {target}, which is not installed")
                    continue
                other = folder_of(target)
                if other is not None and FLOW.index(other) > FLOW.index(own):
                    found.append(f"{source}: includes {target}, which comes later in the flow")
    return found


def self_test():
    planted = {
        "framework/graph/sync/early.h": '#include "graph/report/late.h"\n',
        "framework/graph/report/late.h": "",
        PUBLIC + "/open.h": '#include "graph/sync/early.h"\n',
        "framework/graph/attic/lost.cpp": "",
        "viewer/commands/command_x.cpp": '#include "tests/fixture.h"\n',
        "tests/fixture.h": "",
        "framework/graph/report/good.cpp": '#include "graph/sync/early.h"\n',
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for top in ("framework", "passes", "viewer"):
            (root / top).mkdir()
        for path, text in planted.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        found = breaches(root)
    for guilty in ("early.h", "open.h", "lost.cpp", "command_x.cpp"):
        if not any(guilty in line.split(":")[0] for line in found):
            sys.exit(f"the breach in {guilty} was missed")
    if len(found) != 4:
        sys.exit("\n".join(["four breaches were planted, and these were found:"] + found))


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    lines = breaches(pathlib.Path(sys.argv[1]))
    print("\n".join(lines) if lines else "no include runs against the flow")
    sys.exit(1 if lines else 0)
