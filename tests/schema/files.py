#!/usr/bin/python3
"""Tests that the schema accepts every shipped or documented graph, and rejects every faulty file of tests/diagnostics
whose fault a JSON schema can detect.
  files.py PROGRAM SOURCE_ROOT"""
import json
import pathlib
import sys

import jsonschema

import graph_text

# Codes of faults that a JSON schema can detect: unknown keys, wrong types, missing keys, bad values, unknown types,
# formats and imports.
STRUCTURAL = {"W101", "W102", "W108", "W109", "W115", "W116"}
# Messages of W109 for faults that a schema cannot detect, because they depend on two values.
BEYOND_SCHEMAS = {
    "the default {} is outside", "the default {} is not in the list",
    "the first value of the range is greater than the second",
    "the lower bound is greater than the upper bound", "the name {} is already used",
    "{} is a reserved word of expressions",
    "the pass draws no draw list, so no material can determine culling", "the index of view {} is",
    "whose format is {}, cannot be cleared to", "the size of {} is",
    "is not a valid name for a parameter: no module has the name",
}


def beyond(message):
    return any(all(part in message for part in pattern.split("{}")) for pattern in BEYOND_SCHEMAS)


def documented(root):
    """Yields the name and the value of each complete graph in the documentation."""
    for page in sorted(root.glob("docs/*.md")):
        for kind, name, text, _ in graph_text.snippets(page.read_text()):
            if kind == "file" and name.endswith(".json"):
                yield f"{page.name}: {name}", graph_text.parse(text)


def faulty(root):
    return sorted((root / "tests/diagnostics").rglob("*.json"))


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    failures = []
    text = graph_text.run(program, "schema").stdout
    schema = json.loads(text)
    jsonschema.Draft7Validator.check_schema(schema)
    if text != (root / "graphs/weft.schema.json").read_text():
        failures.append("graphs/weft.schema.json is not what `weft schema` prints: weft schema -o graphs/weft.schema.json")
    validator = jsonschema.Draft7Validator(schema)

    good = [(str(file.relative_to(root)), graph_text.parse(file.read_text())) for file in graph_text.shipped(root)]
    good += documented(root)
    rejected = seen = 0
    for file in faulty(root):
        name = str(file.relative_to(root))
        if file.name.endswith(".good.json") or file.name == "good.json":
            good.append((name, graph_text.parse(file.read_text())))
            continue
        faults = json.loads(graph_text.run(program, "check", "--json", file).stdout or "[]")
        errors = [fault for fault in faults if fault["severity"] == "error"]
        own = [fault for fault in errors if fault["code"] in STRUCTURAL and not beyond(fault["message"])]
        if not own or any(fault["code"].startswith("W0") for fault in errors):
            continue
        seen += 1
        value = graph_text.parse(file.read_text())
        if not validator.is_valid(value):
            rejected += 1
            continue
        # Validates with the graph's own schema, which contains the names in the graph.
        narrow = json.loads(graph_text.run(program, "schema", file).stdout)
        if jsonschema.Draft7Validator(narrow).is_valid(value):
            failures.append(f"{name} is accepted, though: {own[0]['code']} {own[0]['message']}")
    for name, value in good:
        for error in validator.iter_errors(value):
            failures.append(f"{name} is rejected: {error.json_path}: {error.message[:300]}")
    if len(good) < 10 or seen < 5:
        failures.append(f"only {len(good)} good and {seen} faulty files were found")
    return graph_text.verdict(failures, f"{len(good)} good files, {seen} with faults of structure, {rejected} of them "
                                        "rejected by the schema of all graphs")


if __name__ == "__main__":
    sys.exit(main())
