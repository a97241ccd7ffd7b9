# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What is drawn in an SVG or a PDF that cairo has written: circles, lines, rectangles and, in a PDF, texts.

Readers of what cairo writes for drawings of one page, not of all that these formats can hold. Places are from the top left
corner, in pixels of 1/96 inch.
"""

import math
import re
import xml.etree.ElementTree
import zlib
from collections import namedtuple

# colours are (r, g, b) from 0 to 1; fill and stroke are None if there is none
Circle = namedtuple("Circle", "x y r fill opacity stroke")
Line = namedtuple("Line", "x0 y0 x1 y1 stroke width")
Curve = namedtuple("Curve", "points stroke width")
Rectangle = namedtuple("Rectangle", "x y width height fill")
# from `begin` to `end` on a base line: from left to right at the height `along`, or upwards, `along` from the left
Text = namedtuple("Text", "text begin along end size is_upward")


class Drawing:
    def __init__(self):
        self.circles, self.lines, self.curves, self.rectangles, self.texts = [], [], [], [], []

    def add_path(self, pieces, fill, opacity, stroke, width):
        """A path of (operator, points...), as circle, line, curve or rectangle; None if it is nothing of these."""
        points = [p for piece in pieces for p in piece[1:]]
        kinds = "".join(piece[0] for piece in pieces)
        xs, ys = [p[0] for p in points], [p[1] for p in points]
        if re.fullmatch("mc{2,}h?", kinds):
            # it starts at its right end, and half of it is a number of pieces
            r = (max(xs) - min(xs)) / 2
            circle = Circle(xs[0] - r, ys[0], r, fill, opacity, stroke)
            if self.circles and stroke and not fill and self.circles[-1][:3] == circle[:3]:
                circle = self.circles.pop()._replace(stroke=stroke)  # filled before
            self.circles.append(circle)
        elif re.fullmatch("ml", kinds):
            self.lines.append(Line(xs[0], ys[0], xs[1], ys[1], stroke, width))
        elif re.fullmatch("ml{2,}", kinds) and stroke:
            self.curves.append(Curve(points, stroke, width))
        elif re.fullmatch("mlll?h?", kinds) and fill is not None:
            self.rectangles.append(Rectangle(min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys), fill))


def read_svg(path):
    """The drawing and its width and height."""
    root = xml.etree.ElementTree.parse(path).getroot()
    svg = "{http://www.w3.org/2000/svg}"
    assert root.tag == svg + "svg"
    drawing = Drawing()
    symbols = {p for s in root.iter(svg + "defs") for p in s.iter(svg + "path")}  # letters
    for element in root.iter(svg + "path"):
        if element in symbols:
            continue
        style = dict(part.split(":", 1) for part in element.get("style", "").replace(" ", "").split(";") if part)
        style.update({k: v for k, v in element.attrib.items() if k not in ("d", "style")})
        assert "transform" not in style, "a path with a transformation"

        def colour(name):
            text = style.get(name, "none")
            if not text.startswith("rgb"):
                return None
            return tuple(float(c) / 100 for c in re.findall(r"([\d.]+)%", text))

        words = re.findall(r"[A-Za-z]|-?[\d.]+(?:e-?\d+)?", element.get("d"))
        pieces = []
        for word in words:
            if word.isalpha():
                pieces.append([word.lower()])
            else:
                pieces[-1].append(float(word))
        pieces = [[p[0]] + list(zip(p[1::2], p[2::2])) for p in pieces]
        while len(pieces) > 1 and pieces[-1][0] == "m":
            pieces.pop()
        for piece in pieces:
            if piece[0] == "z":
                piece[0] = "h"
        drawing.add_path(pieces, colour("fill"), float(style.get("fill-opacity", 1)), colour("stroke"),
                         float(style.get("stroke-width", 1)))
    assert root.get("width").endswith("px") and root.get("height").endswith("px")
    return drawing, float(root.get("width")[:-2]), float(root.get("height")[:-2])


class Font:
    """What the bytes of a string are, and how wide they are, in units of the font's size."""

    def __init__(self, pdf, body):
        self.bytes = 2 if b"/Type0" in body else 1
        self.characters = {}
        found = re.search(rb"/ToUnicode (\d+) 0 R", body)
        if found:
            for code, text in re.findall(rb"<(\w+)> <(\w+)>\n", pdf.stream(int(found.group(1))).split(b"beginbfchar", 1)[-1]):
                self.characters[int(code, 16)] = bytes.fromhex(text.decode()).decode("utf-16-be")
        if self.bytes == 2:
            body = pdf.objects[int(re.search(rb"/DescendantFonts \[\s*(\d+) 0 R", body).group(1))]
            first, widths = re.search(rb"/W \[\s*(\d+) \[([^\]]*)\]", body).groups()
        else:
            first, widths = (re.search(p, body).group(1) for p in (rb"/FirstChar (\d+)", rb"/Widths \[([^\]]*)\]"))
        self.widths = {int(first) + i: float(w) / 1000 for i, w in enumerate(widths.split())}

    def codes(self, string):
        return [int.from_bytes(string[i:i + self.bytes], "big") for i in range(0, len(string), self.bytes)]

    def text(self, string):
        return "".join(self.characters.get(c) or bytes([c]).decode("cp1252") for c in self.codes(string))

    def width(self, string):
        return sum(self.widths[c] for c in self.codes(string))


class Pdf:
    def __init__(self, path):
        self.data = open(path, "rb").read()
        self.objects = {int(n): body for n, body in re.findall(rb"\n(\d+) 0 obj\n(.*?)\nendobj", self.data, re.S)}

    def stream(self, number):
        head, content = self.objects[number].split(b"stream\n", 1)
        assert b"/FlateDecode" in head
        length = re.search(rb"/Length (\d+)( 0 R)?", head)
        size = int(self.objects[int(length.group(1))]) if length.group(2) else int(length.group(1))
        return zlib.decompress(content[:size])

    def pages(self):
        return [body for body in self.objects.values() if re.search(rb"/Type /Page\b(?!s)", body)]

    def fonts(self):
        result = {}
        for body in self.objects.values():
            for dictionary in re.findall(rb"/Font <<(.*?)>>", body, re.S):
                for name, number in re.findall(rb"/(\S+) (\d+) 0 R", dictionary):
                    result[name.decode()] = Font(self, self.objects[int(number)])
        return result


TOKEN = re.compile(rb"\s*(?:(\((?:\\.|[^\\()])*\))|<([0-9a-fA-F\s]*)>|(/\S+)|([\[\]])|(-?[\d.]+)|([A-Za-z*]+|<<|>>))", re.S)


def plain(string):
    """The bytes of a string in parentheses."""
    escapes = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f"}

    def one(match):
        c = match.group(1)
        return bytes([int(c, 8)]) if c.isdigit() else escapes.get(c, c)

    return re.sub(rb"\\([0-7]{1,3}|.)", one, string[1:-1], flags=re.S)


def times(a, b):
    """The matrix that does a and then b."""
    return (a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3],
            a[4] * b[0] + a[5] * b[2] + b[4], a[4] * b[1] + a[5] * b[3] + b[5])


def at(matrix, x, y):
    return matrix[0] * x + matrix[2] * y + matrix[4], matrix[1] * x + matrix[3] * y + matrix[5]


def read_pdf(path):
    """The drawing and its width and height. It is a PDF of one page."""
    pdf = Pdf(path)
    assert pdf.data.startswith(b"%PDF-1.4\n") and pdf.data.rstrip().endswith(b"%%EOF")
    pages = pdf.pages()
    assert len(pages) == 1, "%d pages" % len(pages)
    box = [float(x) for x in re.search(rb"/MediaBox \[([^\]]*)\]", pages[0]).group(1).split()]
    content = pdf.stream(int(re.search(rb"/Contents (\d+) 0 R", pages[0]).group(1)))
    fonts = pdf.fonts()
    opacities = {n.decode(): float(x) for n, x in re.findall(rb"/(a\d+) << /CA [\d.]+ /ca ([\d.]+)",
                                                             b"".join(b for b in pdf.objects.values()))}
    unit = 96 / 72
    drawing = Drawing()
    identity = (1, 0, 0, 1, 0, 0)
    state = {"m": (unit, 0, 0, -unit, 0, box[3] * unit), "fill": (0, 0, 0), "stroke": (0, 0, 0), "opacity": 1, "width": 1,
             "font": None, "size": 1}
    stack, operands, array, pieces = [], [], None, []
    line_matrix = text_matrix = identity

    def show(parts):
        """Strings, and the distances between them, in thousandths, to the left."""
        nonlocal text_matrix
        font, size = fonts[state["font"]], state["size"]
        for part in parts:
            if isinstance(part, bytes):
                width = font.width(part) * size
                m = times(text_matrix, state["m"])
                (x, y), (end_x, end_y), (up_x, up_y) = at(m, 0, 0), at(m, width, 0), at(m, 0, size)
                is_upward = abs(end_y - y) > abs(end_x - x)
                along, begin, end = (x, y, end_y) if is_upward else (y, x, end_x)
                text = Text(font.text(part), begin, along, end, math.hypot(up_x - x, up_y - y), is_upward)
                last = drawing.texts[-1] if drawing.texts else None
                # cairo changes fonts within a text, and moves letters a little
                if last and last[2:3] + last[5:] == text[2:3] + text[5:] and abs(last.end - begin) < 1:
                    drawing.texts[-1] = last._replace(text=last.text + text.text, end=end)
                else:
                    drawing.texts.append(text)
                text_matrix = times((1, 0, 0, 1, width, 0), text_matrix)
            else:
                text_matrix = times((1, 0, 0, 1, -part / 1000 * size, 0), text_matrix)

    for string, hexadecimal, name, bracket, number, operator in TOKEN.findall(content):
        if string or hexadecimal or name or number:
            value = (plain(string) if string else bytes.fromhex(hexadecimal.decode()) if hexadecimal else
                     name[1:].decode() if name else float(number))
            (operands if array is None else array).append(value)
            continue
        if bracket:
            if bracket == b"[":
                array = []
            else:
                operands.append(array)
                array = None
            continue
        op = operator.decode()
        o, operands = operands, []
        if op == "q":
            stack.append(dict(state))
        elif op == "Q":
            state = stack.pop()
        elif op == "cm":
            state["m"] = times(tuple(o), state["m"])
        elif op in ("rg", "g"):
            state["fill"] = tuple(o) if op == "rg" else (o[0],) * 3
        elif op in ("RG", "G"):
            state["stroke"] = tuple(o) if op == "RG" else (o[0],) * 3
        elif op == "gs":
            state["opacity"] = opacities.get(o[0], 1)
        elif op == "w":
            state["width"] = o[0]
        elif op == "BT":
            line_matrix = text_matrix = identity
        elif op == "Tm":
            line_matrix = text_matrix = tuple(o)
        elif op == "Td":
            line_matrix = text_matrix = times((1, 0, 0, 1, o[0], o[1]), line_matrix)
        elif op == "Tf":
            state["font"], state["size"] = o
        elif op == "Tj":
            show(o)
        elif op == "TJ":
            show(o[0])
        elif op in ("m", "l", "c"):
            pieces.append([op] + [at(state["m"], x, y) for x, y in zip(o[::2], o[1::2])])
        elif op == "h":
            pieces.append(["h"])
        elif op == "re":
            x, y, w, h = o
            corners = [at(state["m"], *p) for p in ((x, y), (x + w, y), (x + w, y + h), (x, y + h))]
            pieces += [["m", corners[0]]] + [["l", c] for c in corners[1:]] + [["h"]]
        elif op in ("f", "f*", "S", "s", "B", "B*", "n"):
            while len(pieces) > 1 and pieces[-1][0] == "m":
                pieces.pop()
            if op != "n" and pieces:
                filled, stroked = op[0] in "fB", op[0] in "SsB"
                drawing.add_path(pieces, state["fill"] if filled else None, state["opacity"],
                                 state["stroke"] if stroked else None, state["width"] * unit)
            pieces = []
    return drawing, box[2] * unit, box[3] * unit
