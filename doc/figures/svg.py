# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Drawings and plots as SVG, with nothing but the standard library.

Every drawing is a light card with dark ink, so that it can be read on pages of any colour.
"""

import base64
import html
import math
import struct
import zlib

INK, GREY, FAINT = "#2d3036", "#6b7078", "#d9dce1"
BLUE, RED, GREEN, VIOLET, AMBER = "#1f6fb4", "#c0392b", "#2e8b57", "#7d3c98", "#d68910"
FONT = "Helvetica, Arial, 'Liberation Sans', sans-serif"


def number(x):
    """As short as a drawing needs it, and the same whatever the platform."""
    text = "%.2f" % x
    return text.rstrip("0").rstrip(".") if "." in text else text


class Drawing:
    def __init__(self, width, height, title):
        self.width, self.height, self.title = width, height, title
        self.parts = []

    def add(self, element, content=None, **attributes):
        text = "<" + element
        for name, value in attributes.items():
            value = number(value) if isinstance(value, float) else str(value)
            text += ' %s="%s"' % (name.rstrip("_").replace("_", "-"), html.escape(value))
        self.parts.append(text + ("/>" if content is None else ">%s</%s>" % (content, element)))

    def text(self, x, y, words, size=14, anchor="start", colour=INK, **attributes):
        """Words; <i>, <b> and <sub> are understood."""
        content = html.escape(words)
        for tag, style in [("i", 'font-style="italic"'), ("b", 'font-weight="bold"'), ("sub", 'font-size="75%" dy="4"')]:
            content = content.replace("&lt;%s&gt;" % tag, "<tspan %s>" % style)
            content = content.replace("&lt;/%s&gt;" % tag,
                                      "</tspan>" + ('<tspan dy="-4">\u200b</tspan>' if tag == "sub" else ""))
        self.add("text", content, x=float(x), y=float(y), font_size=size, text_anchor=anchor, fill=colour, **attributes)

    def line(self, points, colour=INK, width=1.5, **attributes):
        path = " ".join("%s,%s" % (number(x), number(y)) for x, y in points)
        self.add("polyline", points=path, fill="none", stroke=colour, stroke_width=width, stroke_linejoin="round",
                 **attributes)

    def image(self, x, y, width, height, png, smooth=True):
        self.add("image", x=float(x), y=float(y), width=float(width), height=float(height), preserveAspectRatio="none",
                 style="image-rendering:" + ("auto" if smooth else "pixelated"),
                 href="data:image/png;base64," + base64.b64encode(png).decode("ascii"))

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.write('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" '
                       'font-family="%s">\n<title>%s</title>\n' %
                       (self.width, self.height, self.width, self.height, FONT, html.escape(self.title)))
            file.write('<rect width="%d" height="%d" rx="8" fill="#ffffff"/>\n' % (self.width, self.height))
            file.write("\n".join(self.parts) + "\n</svg>\n")


class Axis:
    """Numbers to places on paper."""

    def __init__(self, low, high, ticks, logarithmic=False, labels=None):
        self.low, self.high, self.ticks, self.logarithmic = low, high, ticks, logarithmic
        self.labels = labels or ["%g" % t for t in ticks]

    def fraction(self, x):
        if self.logarithmic:
            return math.log(x / self.low) / math.log(self.high / self.low)
        return (x - self.low) / (self.high - self.low)


class Plot:
    """A rectangle of a drawing with two axes."""

    def __init__(self, drawing, left, top, width, height, x, y, x_name="", y_name="", title=""):
        self.drawing, self.left, self.top, self.width, self.height, self.x, self.y = (drawing, left, top, width, height,
                                                                                     x, y)
        bottom = top + height
        for tick, label in zip(x.ticks, x.labels):
            at = self.left + width * x.fraction(tick)
            drawing.line([(at, top), (at, bottom)], FAINT, 1)
            drawing.text(at, bottom + 17, label, 13, "middle", GREY)
        for tick, label in zip(y.ticks, y.labels):
            at = bottom - height * y.fraction(tick)
            drawing.line([(left, at), (left + width, at)], FAINT, 1)
            drawing.text(left - 6, at + 4.5, label, 13, "end", GREY)
        drawing.text(left + width / 2, bottom + 37, x_name, 14, "middle")
        if y_name:
            drawing.text(0, 0, y_name, 14, "middle",
                         transform="translate(%s %s) rotate(-90)" % (number(left - 46), number(top + height / 2)))
        drawing.text(left + width / 2, top - 9, title, 14, "middle")

    def frame(self):
        self.drawing.add("rect", x=float(self.left), y=float(self.top), width=float(self.width),
                         height=float(self.height), fill="none", stroke=GREY, stroke_width=1)

    def at(self, x, y):
        return (self.left + self.width * self.x.fraction(x), self.top + self.height * (1 - self.y.fraction(y)))

    def curve(self, xs, ys, colour, width=2.2, **attributes):
        self.drawing.line([self.at(x, y) for x, y in zip(xs, ys)], colour, width, **attributes)

    def dots(self, xs, ys, colour, radius=4, fill=None, **attributes):
        for x, y in zip(xs, ys):
            px, py = self.at(x, y)
            self.drawing.add("circle", cx=px, cy=py, r=float(radius), fill=fill or colour, stroke=colour,
                             stroke_width=1.8, **attributes)

    def cross(self, x, y, colour=INK, size=6, width=2):
        px, py = self.at(x, y)
        self.drawing.line([(px - size, py - size), (px + size, py + size)], colour, width)
        self.drawing.line([(px - size, py + size), (px + size, py - size)], colour, width)

    def ellipse(self, x, y, rx, ry, colour, width=2, **attributes):
        px, py = self.at(x, y)
        qx, qy = self.at(x + rx, y + ry)
        self.drawing.add("ellipse", cx=px, cy=py, rx=abs(qx - px), ry=abs(qy - py), fill="none", stroke=colour,
                         stroke_width=width, **attributes)

    def label(self, x, y, words, colour=INK, anchor="start", dx=0, dy=0, size=13):
        px, py = self.at(x, y)
        self.drawing.text(px + dx, py + dy, words, size, anchor, colour)

    def band(self, low, high, colour, opacity=0.15):
        left, right = self.at(low, self.y.low)[0], self.at(high, self.y.low)[0]
        self.drawing.add("rect", x=left, y=float(self.top), width=right - left, height=float(self.height), fill=colour,
                         opacity=opacity)

    def picture(self, rows, colours, low, high):
        """A matrix of numbers, the first row at the bottom, as large as the plot."""
        pixels = [[colours((v - low) / (high - low)) for v in row] for row in reversed(rows)]
        self.drawing.image(self.left, self.top, self.width, self.height, png(pixels))


def png(pixels):
    """Rows of (red, green, blue), 0 to 255."""
    raw = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(pixels[0]), len(pixels), 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")


def size_of_png(data):
    return struct.unpack(">II", data[16:24])


def colour_map(colours):
    """From a list of colours; numbers outside of [0, 1] get those of its ends."""

    def at(t):
        place = min(1.0, max(0.0, t)) * (len(colours) - 1)
        i = min(int(place), len(colours) - 2)
        return tuple(int(round(a + (place - i) * (b - a))) for a, b in zip(colours[i], colours[i + 1]))

    return at
