#!/usr/bin/env python3
"""Checks the links between the files of a folder of pages.
   check_links.py FOLDER      prints each link to a file that does not exist, and fails if there is one"""
import pathlib
import re
import sys

# Links of Markdown and pictures of HTML. A link to a place in a page ends with # and the name of the place.
LINK = re.compile(r'\]\(([^)#\s]*)(?:#[^)\s]*)?\)|src="([^"]*)"')
CODE = re.compile(r"^```.*?^```", re.M | re.S)


def main(folder):
    missing = []
    pages = sorted(pathlib.Path(folder).rglob("*.md"))
    for page in pages:
        for match in LINK.finditer(CODE.sub("", page.read_text())):
            link = match[1] or match[2]
            if link and "://" not in link and not (page.parent / link).exists():
                missing.append(f"{page}: {link}")
    print("\n".join(missing) if missing else f"the links of {len(pages)} pages lead to files")
    return 1 if missing or not pages else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
