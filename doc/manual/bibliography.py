"""The list of references, from a BibTeX file, without BibTeX.

Numbers go by first author and year. What is understood: entries with fields in braces, quotes or as bare numbers, accents
as plain UTF-8.
"""

import html
import re


def entries(text):
    """The entries of a .bib file: dictionaries of their fields, with the key as "key" and the kind as "kind"."""
    result = []
    for head in re.finditer(r"^@(\w+)\s*\{\s*([\w:.-]+)\s*,", text, re.MULTILINE):
        entry = {"kind": head.group(1).lower(), "key": head.group(2)}
        position = head.end()
        while True:
            field = re.compile(r"\s*(\w+)\s*=\s*").match(text, position)
            if not field:
                break
            value, position = field_value(text, field.end())
            entry[field.group(1).lower()] = " ".join(value.replace("{", "").replace("}", "").split())
            comma = re.compile(r"\s*,").match(text, position)
            if not comma:
                break
            position = comma.end()
        if not re.compile(r"\s*\}").match(text, position):
            raise ValueError(f"the entry {entry['key']} does not end where it should")
        result.append(entry)
    return result


def field_value(text, start):
    if text[start] == "{":
        depth = 0
        for position in range(start, len(text)):
            depth += {"{": 1, "}": -1}.get(text[position], 0)
            if depth == 0:
                return text[start + 1:position], position + 1
        raise ValueError("a brace is not closed")
    if text[start] == '"':
        end = text.index('"', start + 1)
        return text[start + 1:end], end + 1
    number = re.compile(r"\d+").match(text, start)
    if not number:
        raise ValueError("a field is neither in braces nor in quotes nor a number: " + text[start:start + 20])
    return number.group(), number.end()


def authors(entry):
    """First name last, as in print."""
    names = []
    for name in entry["author"].split(" and "):
        parts = [part.strip() for part in name.split(",")]
        names.append(" ".join(reversed(parts)))
    return names


def last_name(name):
    return name.split()[-1]


def formatted(entry):
    names = authors(entry)
    text = names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]
    text = html.escape(text) + ". <em>" + html.escape(entry["title"]) + "</em>."
    place = entry.get("journal") or entry.get("booktitle") or entry.get("publisher") or entry.get("institution")
    details = [html.escape(place)] if place else []
    if "volume" in entry:
        details.append(entry["volume"] + ("(" + entry["number"] + ")" if "number" in entry else ""))
    if "pages" in entry:
        details.append("pages " + entry["pages"].replace("--", "–"))
    details.append(entry["year"])
    text += " " + ", ".join(details) + "."
    if "doi" in entry:
        text += f' <a href="https://doi.org/{entry["doi"]}">doi:{entry["doi"]}</a>'
    elif "url" in entry:
        text += f' <a href="{entry["url"]}">{html.escape(entry["url"])}</a>'
    return text


def make(bib_file, page_file, alias_file):
    """Writes a page for doxygen with all entries, and an alias for each, which \\cgalCite expands to."""
    with open(bib_file, encoding="utf-8") as file:
        found = entries(file.read())
    found.sort(key=lambda entry: (last_name(authors(entry)[0]), entry["year"], entry["key"]))
    with open(page_file, "w", encoding="utf-8") as page, open(alias_file, "w", encoding="utf-8") as aliases:
        page.write("/*!\n\\page citelist References\n\n<dl class=\"amf-references\">\n")
        for number, entry in enumerate(found, 1):
            key = entry["key"]
            page.write(f"<dt>\\anchor amf_ref_{key} [{number}]</dt><dd>{formatted(entry)}</dd>\n")
            aliases.write(f'ALIASES += "amf_cite_{key}=\\ref amf_ref_{key} \\"[{number}]\\""\n')
        page.write("</dl>\n*/\n")
