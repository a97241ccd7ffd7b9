#!/usr/bin/env python3
"""Checks the links of the manual: every link to a page, an anchor, a picture, a script or a stylesheet of the manual leads
to one that is there; nothing is loaded from elsewhere, so that the manual can be read without a network.

  check_links.py FOLDER_OF_HTML

Links that a reader may follow to other sites are counted, not visited.
"""

import argparse
import html.parser
import json
import pathlib
import re
import sys
import urllib.parse

# What a page loads by itself, in contrast to what a reader follows.
LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(html.parser.HTMLParser):
    """The anchors of a page and its links: (tag, attribute, target, line)."""

    def __init__(self, text):
        super().__init__()
        self.anchors = {""}
        self.links = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif (tag, name) in LOADED or name == "href":
                self.links.append((tag, name, value or "", self.getpos()[0]))
            elif name == "srcset":
                self.links += [(tag, name, part.split()[0], self.getpos()[0]) for part in value.split(",")]


def is_elsewhere(target):
    return re.match(r"[a-z][a-z0-9+.-]*:|//", target, re.IGNORECASE) is not None


def check(folder):
    """Returns the faults, and how many links were looked at and how many lead elsewhere."""
    pages = {path.name: Page(path.read_text(encoding="utf-8")) for path in folder.glob("*.html")}
    faults = []
    inside = outside = 0
    links = [(name, f"{name}:{line}", tag, attribute, target)
             for name, page in pages.items() for tag, attribute, target, line in page.links]
    # what the search leads to
    index = folder / "manual_index.js"
    if index.exists():
        rows = json.loads(re.sub(r"^var \w+ = |;\s*$", "", index.read_text(encoding="utf-8")))
        links += [(index.name, f"{index.name}: {row[0]}", "a", "href", row[3]) for row in rows]
    for sheet in folder.glob("*.css"):
        for target in re.findall(r"url\(\s*['\"]?([^'\")]+)", sheet.read_text(encoding="utf-8")):
            links.append((sheet.name, sheet.name, "link", "href", target))
    for name, place, tag, attribute, target in links:
        if is_elsewhere(target):
            outside += 1
            if (tag, attribute) in LOADED and not target.startswith("data:"):
                faults.append(f"{place}: loads {target} from elsewhere")
            continue
        inside += 1
        path, _, anchor = target.partition("#")
        path, anchor = urllib.parse.unquote(path.partition("?")[0]), urllib.parse.unquote(anchor)
        if path in ("", name):
            path = name
        elif not (folder / path).is_file():
            faults.append(f"{place}: {target}: there is no such file")
            continue
        if anchor and (path not in pages or anchor not in pages[path].anchors):
            faults.append(f"{place}: {target}: there is no such anchor")
    if not pages:
        faults.append(f"{folder}: there are no pages")
    return faults, inside, outside


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="the folder of index.html")
    folder = parser.parse_args().folder
    faults, inside, outside = check(folder)
    for fault in faults:
        print(fault)
    print(f"links within the manual: {inside}, dead: {len(faults)}; links to other sites: {outside}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
