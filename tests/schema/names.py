#!/usr/bin/python3
"""Tests `weft schema FILE`: the schema of a graph accepts the graph, and rejects it if one of its names is misspelt.
  names.py PROGRAM SOURCE_ROOT"""
import copy
import json
import pathlib
import sys
import tempfile

import jsonschema

import graph_text

SLIP = "Slip"


def reference(text):
    """Misspells the resource in a reference: hdr@glass → hdrSlip@glass. If a port is an object, its "ref" changes."""
    if isinstance(text, dict):
        return {**text, "ref": reference(text["ref"])}
    end = next((i for i, c in enumerate(text) if c in "@[."), len(text))
    return text[:end] + SLIP + text[end:]


def slips(graph):
    """Yields (description, graph with one misspelt name) for every name that only the graph's own schema knows."""
    for name, body in graph["passes"].items():
        # A null body removes the pass of the included graph, so there are no names to misspell.
        if body is None:
            continue
        for key in ("in", "out"):
            ports = body.get(key, [])
            # A null port removes the port of the included pass, so there is no name to misspell, either.
            if isinstance(ports, dict):
                ports = {port: ref for port, ref in ports.items() if ref is not None}
            for i in (range(len(ports)) if isinstance(ports, list) else list(ports)):
                yield from changed(graph, ["passes", name, key, i], reference)
            if isinstance(ports, dict):
                for port in ports:
                    slip = copy.deepcopy(graph)
                    at = slip["passes"][name][key]
                    at[port + SLIP] = at.pop(port)
                    # Copy and blit passes are skipped, because their ports may have any name.
                    if body.get("type") in ("compute", "fullscreen", "raster"):
                        yield f"{name}.{key}: port {port}", slip
        for key in ("params", "constants"):
            for member in body.get(key, {}):
                slip = copy.deepcopy(graph)
                slip["passes"][name][key][member + SLIP] = slip["passes"][name][key].pop(member)
                yield f"{name}.{key}.{member}", slip
        if isinstance(body.get("depth"), str):
            yield from changed(graph, ["passes", name, "depth"], reference)
        if isinstance(body.get("draws"), list):
            yield from changed(graph, ["passes", name, "draws", 0], reference)
        # Without these keys, the included file determines the kind of shader.
        if "shader" in body and "type" in body:
            yield from changed(graph, ["passes", name, "shader"], lambda text: SLIP + text)
        if "after" in body:
            yield from changed(graph, ["passes", name, "after", 0], reference)


def changed(graph, path, change):
    slip = copy.deepcopy(graph)
    at = slip
    for step in path[:-1]:
        at = at[step]
    at[path[-1]] = change(at[path[-1]])
    yield ".".join(map(str, path)), slip


TIERED = """{ "version": 1, "include": ["deferred.json"], "debug": { "Lit": "hdr" },
  "tiers": { "low": { "set": { "exposure": 1 }, "patch": { "passes": { "tonemap": { "in": { "hdr": "hdr@glass" } } } } } },
  "tests": [{ "tiers": ["low"], "params": { "exposure": 2 }, "expect": { "finite": ["hdr"], "range": { "hdr": [0, 1] } } }],
  "passes": { "glass": { "after": ["lighting"] } } }"""
TIERED_SLIPS = ['"exposure": 1', '"exposure": 2', '"tonemap": { "in": { "hdr"', '"hdr@glass"', '["low"]', '["hdr"]',
                '"Lit": "hdr"', '"range": { "hdr"', '["lighting"]']


def check_tiers(program, failures):
    """Yields (description, graph with one misspelt name) for the names in tiers, tests and debug views."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "tiered.json"
        file.write_text(TIERED)
        validator = own_validator(program, file)
        for error in validator.iter_errors(graph_text.parse(TIERED)):
            failures.append(f"tiers: {error.json_path}: {error.message[:300]}")
        for part in TIERED_SLIPS:
            assert TIERED.count(part) == 1, part
            for word in ("exposure", "hdr", "low", "lighting"):
                slip = TIERED.replace(part, part.replace(f'"{word}', f'"{word}{SLIP}'))
                if slip != TIERED and validator.is_valid(graph_text.parse(slip)):
                    failures.append(f"accepted: {part} with {word}{SLIP}")


def own_validator(program, file):
    run = graph_text.run(program, "schema", file)
    assert run.returncode == 0, run.stderr
    schema = json.loads(run.stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    failures, count = [], 0
    # Modules are skipped, because they may use names that only the including graphs declare.
    files = [file for file in graph_text.shipped(root) if file.parent.name != "modules"]
    for file in files:
        graph = graph_text.parse(file.read_text())
        if "passes" not in graph:
            continue
        validator = own_validator(program, file)
        for error in validator.iter_errors(graph):
            failures.append(f"{file.name}: {error.json_path}: {error.message[:300]}")
        for what, slip in slips(graph):
            count += 1
            if validator.is_valid(slip):
                failures.append(f"{file.name}: accepted with a slip in {what}")
    check_tiers(program, failures)
    # `weft schema` must refuse a missing file, and a file that is not JSON, with exit code 3.
    for bad in ("nowhere.json", "tests/diagnostics/W001_quote.json"):
        if graph_text.run(program, "schema", root / bad).returncode != 3:
            failures.append(f"{bad} is not exit code 3")
    if count < 100:
        failures.append(f"only {count} names were misspelt")
    return graph_text.verdict(failures, f"{len(files)} graphs accepted, {count} slips rejected")


if __name__ == "__main__":
    sys.exit(main())
