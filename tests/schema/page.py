#!/usr/bin/python3
"""Tests the examples in docs/format.md: `weft check` accepts each of them, their tests pass, and their debug views can
be drawn. Every key of the format must occur in an example.
An example after `<!-- file: NAME -->` is the content of file NAME. An example after `<!-- over: NAME -->` is a part of
a graph that includes file NAME. `<!-- file: NAME needs KEY -->` is a graph for devices whose profile has KEY above 0:
`weft check` must accept it for the profile `discrete`, and must name KEY or a Vulkan feature for the profile `lavapipe`.
  page.py PROGRAM SOURCE_ROOT"""
import json
import pathlib
import sys
import tempfile

import jsonschema

import graph_text

DEFINITIONS = "#/definitions/"


class KeyWalk:
    """Collects the keys of the schema's definitions that a graph uses."""

    def __init__(self, schema):
        self.schema = schema
        self.used = set()

    def holds(self, schema, value):
        whole = {**schema, "definitions": self.schema["definitions"]} if isinstance(schema, dict) else schema
        return jsonschema.Draft7Validator(whole).is_valid(value)

    def visit(self, schema, value, place):
        if not isinstance(schema, dict):
            return
        if "$ref" in schema:
            parts = schema["$ref"][len(DEFINITIONS):].split("/")
            target = self.schema["definitions"][parts[0]]
            for part in parts[1:]:
                target = target[part]
            # This key is defined once and shared by several kinds of objects.
            if len(parts) == 3:
                self.used.add((parts[0].removesuffix(".patch"), parts[2]))
                return self.visit(target, value, place)
            return self.visit(target, value, parts[0].removesuffix(".patch"))
        for part in schema.get("anyOf", []):
            if self.holds(part, value):
                self.visit(part, value, place)
        for part in schema.get("allOf", []):
            self.visit(part, value, place)
        if "if" in schema:
            self.visit(schema.get("then" if self.holds(schema["if"], value) else "else"), value, place)
        if isinstance(value, dict):
            for key, inner in value.items():
                known = schema.get("properties", {})
                if key in known:
                    self.used.add((place, key))
                self.visit(known.get(key, schema.get("additionalProperties")), inner, place)
        if isinstance(value, list) and isinstance(schema.get("items"), dict):
            for item in value:
                self.visit(schema["items"], item, place)


def all_keys(schema):
    """Returns (definition, key) of all objects. All kinds of passes share their keys; all kinds of resources do too."""
    keys = {("graph", key) for key in schema["properties"]}
    for name, definition in schema["definitions"].items():
        kinds = name.endswith("Pass") and name != "anyPass" or name.endswith("Resource") or name == "pass"
        if not name.endswith(".patch") and not kinds:
            keys |= {(name, key) for key in definition.get("properties", {})}
    return keys


def runs(program, file, graph, folder, has_device):
    """Checks the graph. If there is a device, also runs the tests of the graph and renders its debug views."""
    yield graph_text.run(program, "check", file, folder=folder)
    if has_device and "tests" in graph:
        yield graph_text.run(program, "check", "--run", file, folder=folder)
    for view in graph.get("debug", {}) if has_device else ():
        yield graph_text.run(program, "render", "builtin:spheres", "--graph", file, "--debug", view, "--size", "64x48",
                             "--validate", "-o", "view.png", folder=folder)


def fault_of_need(program, file, need, folder):
    """Returns what is wrong with the check of a graph that not all devices can run; empty: nothing."""
    good = graph_text.run(program, "check", file, "--profile", "discrete", folder=folder)
    if good.returncode != 0:
        return f"for the profile discrete: {good.stderr}"
    bad = graph_text.run(program, "check", file, "--profile", "lavapipe", "--json", folder=folder)
    found = json.loads(bad.stdout)
    if bad.returncode != 3 or len(found) != 1 or need not in found[0]["message"] + "".join(found[0]["help"]):
        return f"for the profile lavapipe, wanted one error that names {need}: {bad.stdout}"
    return ""


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    page = (root / "docs/format.md").read_text()
    schema = json.loads(graph_text.run(program, "schema").stdout)
    validator = jsonschema.Draft7Validator(schema)
    walk = KeyWalk(schema)
    failures, count = [], 0
    has_device = graph_text.run(program, "doctor").returncode == 0
    unmarked = page.count("```json") - sum(name.endswith(".json") for _, name, _, _ in graph_text.snippets(page))
    if unmarked:
        failures.append(f"{unmarked} JSON examples without a mark")
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for number, (kind, name, text, need) in enumerate(graph_text.snippets(page)):
            file = pathlib.Path(folder) / name
            if kind == "over":
                text = '{ "version": 1, "include": ["%s"],\n%s}\n' % (name, text)
                file = pathlib.Path(folder) / f"example{number}.json"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            if file.suffix == ".json":
                files.append((file, need))
        for file, need in files:
            count += 1
            graph = graph_text.parse(file.read_text())
            for error in validator.iter_errors(graph):
                failures.append(f"schema: {error.json_path}: {error.message[:200]}\n{file.read_text()}")
            walk.visit(schema, graph, "graph")
            if need:
                failures += filter(None, [fault_of_need(program, file.name, need, folder)])
                continue
            # A file with ports is a module: a graph that includes it is another example.
            if "ports" in graph:
                continue
            for run in runs(program, file.name, graph, folder, has_device):
                if run.returncode != 0:
                    failures.append(f"{' '.join(run.args[1:])}: {run.stderr}\n{file.read_text()}")
    for place, key in sorted(all_keys(schema) - walk.used):
        failures.append(f"no example has the key \"{key}\" of \"{place}\"")
    where = "" if has_device else ", without a device"
    return graph_text.verdict(failures, f"{count} examples, {len(walk.used & all_keys(schema))} keys{where}")


if __name__ == "__main__":
    sys.exit(main())
