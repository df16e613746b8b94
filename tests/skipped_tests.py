#!/usr/bin/env python3
"""Fails if a test was skipped for a reason that is not in the list of accepted reasons.
   skipped_tests.py JUNIT_XML REASONS    JUNIT_XML: ctest --output-junit; REASONS: tests/skipped_tests.txt
   skipped_tests.py --self-test"""
import sys
import xml.etree.ElementTree as xml


def accepted_reasons(text):
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    for line in lines:
        if " -- " not in line:
            sys.exit(f"no ' -- ' and explanation behind the reason: {line}")
    return [line.split(" -- ")[0] for line in lines]


def unaccepted(junit, reasons):
    """Returns the number of skipped tests, and a line for each test that was skipped for no accepted reason."""
    skipped, lines = 0, []
    for case in xml.fromstring(junit).iter("testcase"):
        if case.find("skipped") is None and case.get("status") != "notrun":
            continue
        skipped += 1
        output = case.findtext("system-out") or ""
        if not any(reason in output for reason in reasons):
            lines.append(f"{case.get('name')} was skipped for no reason that tests/skipped_tests.txt lists:\n{output}")
    return skipped, lines


def self_test():
    case = '<testcase name="{0}" status="{1}">{2}<system-out>{3}</system-out></testcase>'
    skip = '<skipped message=""/>'
    junit = "<testsuite>" + case.format("ran", "run", "", "") + case.format("listed", "notrun", skip, "set SLOW=1") + \
        case.format("surprise", "notrun", skip, "no Vulkan device") + "</testsuite>"
    count, lines = unaccepted(junit, accepted_reasons("# comment\nSLOW -- takes minutes\n"))
    if count != 2 or len(lines) != 1 or not lines[0].startswith("surprise "):
        sys.exit(f"of two skipped tests one is not on the list, and this was found: {count} {lines}")


if sys.argv[1:] == ["--self-test"]:
    self_test()
else:
    with open(sys.argv[1]) as junit, open(sys.argv[2]) as reasons:
        count, lines = unaccepted(junit.read(), accepted_reasons(reasons.read()))
    print("\n".join(lines) if lines else f"{count} tests were skipped, all for reasons that tests/skipped_tests.txt lists")
    sys.exit(1 if lines else 0)
