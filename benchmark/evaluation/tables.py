# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tables of the manual: Markdown, as doxygen reads it."""

import re


def rounded(x):
    return f"{x:.0f}"


def share(x):
    """Two decimals without the zero before them; what is not defined is a dash."""
    if x is None:
        return "-"
    return "1.0" if x >= .995 else f"{x:.2f}".lstrip("0")


def pair(a, b):
    return f"{share(a)} / {share(b)}"


def with_chance(*figures):
    """A cell for each (value, chance)."""
    return [f"{share(value)} ({share(chance)})" for value, chance in figures]


def markdown(head, rows):
    lines = [head, [":---"] + ["---:"] * (len(head) - 1), *rows]
    return "".join("| " + " | ".join(str(c) for c in line) + " |\n" for line in lines)


def put_into(page, key, text):
    """Replaces what is between <!-- table KEY --> and <!-- end --> in a page."""
    content = page.read_text(encoding="utf-8")
    pattern = re.compile(rf"(<!-- table {re.escape(key)} -->\n).*?(<!-- end -->)", re.DOTALL)
    if not pattern.search(content):
        raise ValueError(f"{page}: has no table \"{key}\"")
    page.write_text(pattern.sub(lambda m: m.group(1) + "\n" + text + "\n" + m.group(2), content), encoding="utf-8")
