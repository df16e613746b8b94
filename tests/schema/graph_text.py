"""Reads JSON with comments and trailing commas as Weft does, for tools that know only plain JSON."""
import json
import re
import subprocess

STRING = r'"(?:[^"\\\n]|\\.)*"'
COMMENT = re.compile(STRING + r"|//[^\n]*|/\*.*?\*/", re.S)
TRAILING_COMMA = re.compile(STRING + r"|,(?=\s*[}\]])")


def plain(text):
    """Returns the text without comments and trailing commas. Strings do not change."""
    for unwanted in (COMMENT, TRAILING_COMMA):
        text = unwanted.sub(lambda match: match[0] if match[0].startswith('"') else " ", text)
    return text


def parse(text):
    return json.loads(plain(text))


def run(program, *arguments, folder=None):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=folder, timeout=1500)


def shipped(root):
    """Returns the files of the shipped graphs and of the example graphs."""
    graphs = [file for folder in ("graphs", "docs/examples") for file in sorted((root / folder).rglob("*.json"))]
    return [file for file in graphs if file.name != "weft.schema.json"]


def snippets(page):
    """Returns (kind, name, text, need) of each fenced block with a comment before it. The kind is "file" or "over". The
    need is the key of device profiles that must be above 0 for the graph; empty: all devices can run it."""
    mark = re.compile(r"^<!-- (file|over): (\S+)(?: needs (\w+))? -->\n+```\w*\n(.*?)^```", re.S | re.M)
    return [(kind, name, text, need or "") for kind, name, need, text in (m.groups() for m in mark.finditer(page))]


def verdict(failures, summary):
    """Prints the failures and a summary, and returns the exit code of the test."""
    print("\n".join(failures))
    print(summary)
    return 1 if failures else 0


def self_test():
    cases = {
        '{"a": 1, // one\n "b": [2, 3,], /* , */ }': {"a": 1, "b": [2, 3]},
        '{"url": "http://x/*y*/", "q": "\\"//,]",}': {"url": "http://x/*y*/", "q": '"//,]'},
        '[1, // a, ]\n /* ] */ 2 /* , */, // b\n]': [1, 2],
        '{"a": [[1,],],}': {"a": [[1]]},
        '["a,}", ",]"]': ["a,}", ",]"],
    }
    for text, value in cases.items():
        assert parse(text) == value, text
    for text in ('{"a": 1,, "b": 2}', '[,]x', '{"a" 1}'):
        try:
            parse(text)
        except ValueError:
            continue
        raise AssertionError(f"{text} is no JSON")


self_test()
