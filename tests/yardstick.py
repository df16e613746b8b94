#!/usr/bin/python3
"""Measures what a part of a pipeline costs its author: the lines and JSON tokens of some passes of a graph, and of the
resources that belong to these passes. A resource belongs to them if no other pass writes it, and if the given passes
write it or no other pass reads it.
  yardstick.py GRAPH.json PASS... [--also RESOURCE]... [--lines MOST] [--tokens MOST]
  yardstick.py --self-test
A token is a string, a number, true, false, null, or one of { } [ ] : , inside an entry `"name": value`. The comma after
an entry belongs to the object around it. --also counts a resource that other passes write too. A line counts if such an
entry has a token on it. A line of more than 120 columns is an error, and so is a pass that does not exist. The script
fails if a number exceeds its limit MOST."""
import argparse
import re
import sys
from typing import NamedTuple

MOST_COLUMNS = 120
TOKEN = re.compile(r'(?P<blank>\s+|//[^\n]*|/\*.*?\*/)|(?P<token>"(?:[^"\\]|\\.)*"|[{}\[\]:,]|[^\s{}\[\]:,"/]+)', re.S)
BASE_NAME = re.compile(r"[^@.\[]+")


class Token(NamedTuple):
    text: str
    line: int


class Entry(NamedTuple):
    """An entry `"name": value` of an object: its tokens, and the entries of the value if the value is an object."""
    tokens: list
    members: dict
    # All values in the entry that are strings, with nested values.
    strings: list


def tokens_of(text):
    tokens, line, at = [], 1, 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"line {line}: not JSON: {text[at:at + 20]!r}")
        if match["token"]:
            tokens.append(Token(match["token"], line))
        line += match[0].count("\n")
        at = match.end()
    return tokens


def value_at(tokens, i):
    """Reads the value at index i. Returns the index after the value, its entries by name, and its strings."""
    if tokens[i].text == "{":
        return object_at(tokens, i)
    if tokens[i].text == "[":
        strings, i = [], i + 1
        while tokens[i].text != "]":
            i, _, inner = value_at(tokens, i)
            strings += inner
            i += tokens[i].text == ","
        return i + 1, {}, strings
    return i + 1, {}, [tokens[i].text[1:-1]] if tokens[i].text.startswith('"') else []


def object_at(tokens, i):
    entries, strings, i = {}, [], i + 1
    while tokens[i].text != "}":
        first, name = i, tokens[i].text[1:-1]
        i, members, inner = value_at(tokens, i + 2)
        entries[name] = Entry(tokens[first:i], members, inner)
        strings += inner
        i += tokens[i].text == ","
    return i + 1, entries, strings


def named_resources(entry, keys, resources):
    """Returns the resources that these keys of a pass refer to. A port without a reference is named as its resource."""
    named = set()
    for key in keys:
        if key in entry.members:
            part = entry.members[key]
            names = part.strings + list(part.members)
            named |= {BASE_NAME.match(name)[0] for name in names if BASE_NAME.match(name)} & set(resources)
    return named


def own_resources(passes, all_passes, resources):
    def named(names, keys):
        return set().union(*(named_resources(all_passes[name], keys, resources) for name in names))
    others = [name for name in all_passes if name not in passes]
    outputs, ports = ("out", "depth", "resolve"), ("in", "out", "depth", "resolve", "groups", "draws")
    made = named(passes, outputs)
    return named(passes, ports) - named(others, outputs) - (named(others, ports) - made)


def measure(text, passes, also=()):
    """Returns the number of lines, the number of tokens, and the resources that belong to these passes. A name may also
    be that of a group, which counts as a whole; `also` names the resources that its passes write."""
    _, graph, _ = object_at(tokens_of(text), 0)
    all_passes, resources = graph["passes"].members, graph["resources"].members if "resources" in graph else {}
    all_passes |= graph["groups"].members if "groups" in graph else {}
    missing = [name for name in passes if name not in all_passes]
    if missing:
        raise ValueError(f"there is no pass {missing[0]}, but " + ", ".join(all_passes))
    own = sorted(own_resources(passes, all_passes, resources) | set(also))
    if set(own) - set(resources):
        raise ValueError(f"there is no such resource: {', '.join(set(own) - set(resources))}")
    tokens = [t for entry in [all_passes[p] for p in passes] + [resources[r] for r in own] for t in entry.tokens]
    lines = {t.line for t in tokens}
    columns = {n: len(line) for n, line in enumerate(text.split("\n"), 1)}
    long = sorted(n for n in lines if columns[n] > MOST_COLUMNS)
    if long:
        raise ValueError(f"line {long[0]} has more than {MOST_COLUMNS} columns")
    return len(lines), len(tokens), own


SAMPLE = r"""// A comment with "strings" and { braces }
{
  "version": 1,
  "resources": { "a": "rgba8", "b": { "format": "rgba16f", "history": 1 },
    "c": "r8", /* two
    lines */ "d": "r8" },
  "passes": {
    "first":  { "type": "clear", "out": ["a"], },
    "second": { "type": "compute", "shader": "x//y.comp", "params": { "k": -1.5e3, "on": true },
                "in": { "src": "a@first.mip(0)", "prev": "b[-1]" }, "out": { "b": "b" } },
    "third":  { "type": "copy", "in": ["b"], "out": { "dst": { "ref": "c.mip(0)" } } }
  }
}
"""


def self_test():
    # The pass is `"first" : { "type" : "clear" , "out" : [ "a" ] , }` with 14 tokens. It makes resource a with 3
    # tokens, which another pass reads.
    assert measure(SAMPLE, ["first"]) == (2, 17, ["a"]), measure(SAMPLE, ["first"])
    # The pass has 2 + {} + 3 + 3 + (2 + 9) + (2 + 9) + (2 + 5) tokens and 4 commas. Another pass makes a. Resource b
    # has 11 tokens, in the line of a.
    assert measure(SAMPLE, ["second"]) == (3, 43 + 11, ["b"]), measure(SAMPLE, ["second"])
    # The pass has 2 + {} + 3 + 5 + (2 + 2 + 2 + 5) + 2 tokens. Resource c has 3 tokens in a line of its own. Another
    # pass makes b.
    assert measure(SAMPLE, ["third"]) == (2, 28, ["c"]), measure(SAMPLE, ["third"])
    assert measure(SAMPLE, ["second", "third"]) == (5, 43 + 11 + 28, ["b", "c"]), measure(SAMPLE, ["second", "third"])
    # The group is `"g" : { "passes" : { "fill" : { "type" : "clear" } } }` with 15 tokens.
    grouped = SAMPLE.replace('"passes": {', '"groups": { "g": { "passes": { "fill": { "type": "clear" } } } },\n  "passes": {', 1)
    assert measure(grouped, ["g"], ["d"]) == (2, 15 + 3, ["d"]), measure(grouped, ["g"], ["d"])
    assert measure(SAMPLE, ["third"], ["d"]) == (3, 31, ["c", "d"]), measure(SAMPLE, ["third"], ["d"])
    for bad, passes, what in ((SAMPLE, ["fourth"], "no pass fourth"), (SAMPLE.replace('"a": "rgba8"', " " * 99 + '"a": "rgba8"'), ["first"], "120 columns"),
                              (SAMPLE + '"', ["first"], "not JSON")):
        try:
            measure(bad, passes)
        except ValueError as fault:
            assert what in str(fault), fault
        else:
            raise AssertionError(what + " goes unnoticed")
    print("the yardstick is straight")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("graph")
    arguments.add_argument("passes", nargs="+", metavar="PASS")
    arguments.add_argument("--also", action="append", default=[], metavar="RESOURCE")
    arguments.add_argument("--lines", type=int, metavar="MOST")
    arguments.add_argument("--tokens", type=int, metavar="MOST")
    given = arguments.parse_args()
    with open(given.graph, encoding="utf-8") as file:
        lines, tokens, own = measure(file.read(), given.passes, given.also)
    print(f"{given.graph}: {', '.join(given.passes)}: {lines} lines, {tokens} tokens"
          + (f", with {', '.join(own)}" if own else ""))
    too_much = (given.lines is not None and lines > given.lines) or (given.tokens is not None and tokens > given.tokens)
    if too_much:
        print(f"more than {given.lines} lines or {given.tokens} tokens", file=sys.stderr)
    return 1 if too_much else 0


try:
    sys.exit(main())
except (OSError, ValueError) as fault:
    sys.exit(f"yardstick: {fault}")
