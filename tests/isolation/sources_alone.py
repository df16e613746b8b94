#!/usr/bin/env python3
"""Compiles each source by itself, without precompiled headers, and writes no object files.

The release build compiles all sources of a folder as one, with precompiled headers. There, a source can lack an #include
without an error. The presets `debug` and `fuzz` compile sources one by one, so they would fail.

    sources_alone.py SOURCE_ROOT BUILD_FOLDER
    sources_alone.py --self-test
"""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile


def compile_commands(root, build):
    """Configures a build without unity and precompiled headers. Returns its compile commands."""
    subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug", "-DWEFT_UNITY=OFF",
                    "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"], check=True, stdout=subprocess.DEVNULL)
    return json.loads((pathlib.Path(build) / "compile_commands.json").read_text())


def errors_of(entry):
    """Returns the file and the compiler's messages; the messages are empty if the file compiles."""
    done = subprocess.run(entry["command"] + " -fsyntax-only", shell=True, cwd=entry["directory"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return entry["file"], done.stdout if done.returncode else ""


def check(entries):
    """Compiles each file once, although several targets may contain it. Returns the number of files that fail."""
    files = {entry["file"]: entry for entry in entries}
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, (file, messages) in enumerate(pool.map(errors_of, files.values()), 1):
            if messages:
                failed += 1
                print(f"{file} does not compile by itself:\n{messages}", flush=True)
            if number % 100 == 0:
                print(f"{number} of {len(files)} sources", flush=True)
    print(f"{len(files) - failed} of {len(files)} sources compile by themselves")
    return failed


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        entries = []
        for name, text in {"good.cpp": "#include <string>\nstd::string f();\n", "bad.cpp": "std::string f();\n"}.items():
            (pathlib.Path(folder) / name).write_text(text)
            entries.append({"file": name, "directory": folder, "command": f"c++ -c {name} -o {name}.o"})
        assert check(entries) == 1, "a source without its #include must fail"
        assert check(entries[:1]) == 0, "a complete source must compile"


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    sys.exit(check(compile_commands(*sys.argv[1:])) > 0)
