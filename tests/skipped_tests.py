#!/usr/bin/env python3
"""Fails if a test was skipped for a reason that is not in the list of accepted reasons.
   skipped_tests.py JUNIT_XML RESULTS REASONS    JUNIT_XML: ctest --output-junit; RESULTS: the folder with the results of
                                                 the GoogleTest suites; REASONS: tests/skipped_tests.txt
   skipped_tests.py --self-test"""
import pathlib
import sys
import xml.etree.ElementTree as xml


def accepted_reasons(text):
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    for line in lines:
        if " -- " not in line:
            sys.exit(f"no ' -- ' and explanation behind the reason: {line}")
    return [line.split(" -- ")[0] for line in lines]


def unaccepted(results, reasons):
    """`results`: the text of a file that ctest or GoogleTest has written. Returns the number of skipped tests, and a line for each test that was skipped for no accepted reason."""
    skipped, lines = 0, []
    for case in xml.fromstring(results).iter("testcase"):
        if case.find("skipped") is None and case.get("status") not in ("notrun", "disabled"):
            continue
        skipped += 1
        said = case.find("skipped").get("message") if case.find("skipped") is not None else ""
        output = said + (case.findtext("system-out") or "")
        if not any(reason in output for reason in reasons):
            lines.append(f"{case.get('name')} was skipped for no reason that tests/skipped_tests.txt lists:\n{output}")
    return skipped, lines


def self_test():
    reasons = accepted_reasons("# comment\nSLOW -- takes minutes\n")
    of_ctest = '<testcase name="{0}" status="{1}">{2}<system-out>{3}</system-out></testcase>'
    of_googletest = '<testcase name="{0}" status="run" result="{1}">{2}</testcase>'
    skip = '<skipped message="{}"><![CDATA[file.cpp:1]]></skipped>'
    files = {
        "ctest": of_ctest.format("ran", "run", "", "") + of_ctest.format("listed", "notrun", skip.format(""), "set SLOW=1") +
                 of_ctest.format("surprise", "notrun", skip.format(""), "no Vulkan device"),
        "GoogleTest": of_googletest.format("ran", "completed", "") +
                      of_googletest.format("listed", "skipped", skip.format("set SLOW=1")) +
                      of_googletest.format("surprise", "skipped", skip.format("no Vulkan device"))}
    for writer, cases in files.items():
        count, lines = unaccepted(f"<testsuite>{cases}</testsuite>", reasons)
        if count != 2 or len(lines) != 1 or not lines[0].startswith("surprise "):
            sys.exit(f"{writer}: of two skipped tests one is not on the list, and this was found: {count} {lines}")


def main(junit, results, reasons_file):
    with open(reasons_file) as file:
        reasons = accepted_reasons(file.read())
    count, lines = 0, []
    for path in [pathlib.Path(junit), *sorted(pathlib.Path(results).glob("*.xml"))]:
        more, found = unaccepted(path.read_text(errors="replace"), reasons)
        count += more
        lines += found
    print("\n".join(lines) if lines else f"{count} tests were skipped, all for reasons that tests/skipped_tests.txt lists")
    sys.exit(1 if lines else 0)


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    main(*sys.argv[1:])
