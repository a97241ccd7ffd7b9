#!/usr/bin/env python3
"""Checks that every public entity of the package is documented and belongs to a group.

  check_entities.py [--list] [--source CHECKOUT] --work FOLDER

doxygen is told to extract everything, documented or not, and its XML is read. Public are: classes and their public
members, enumerators, and what is declared in a namespace; all but what is in a namespace `internal`. Not asked for are
what the compiler would write as well (deleted and defaulted functions, destructors) and declarations of friend classes.
"""

import argparse
import pathlib
import shutil
import sys
import xml.etree.ElementTree as ElementTree

import make_manual

SETTINGS = """
EXTRACT_ALL = YES
GENERATE_HTML = NO
GENERATE_TAGFILE =
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
WARNINGS = NO
"""


class Entity:
    """What is declared, and where."""

    def __init__(self, node, name, kind, is_grouped):
        self.name = name
        self.kind = kind
        self.is_documented = has_text(node)
        self.is_grouped = is_grouped
        location = node.find("location")
        self.place = "" if location is None else f"{location.get('file')}:{location.get('line')}"


def has_text(node):
    """Whether it says what the entity is: a list of parameters and exceptions alone does not."""
    for part in ("briefdescription", "detaileddescription"):
        for paragraph in node.iterfind(part + "/para"):
            own = (paragraph.text or "") + "".join(
                "".join(child.itertext()) * (child.tag not in ("parameterlist", "simplesect")) + (child.tail or "")
                for child in paragraph)
            if own.strip():
                return True
    return False


def is_written_by_the_compiler(member):
    arguments = member.findtext("argsstring") or ""
    return arguments.replace(" ", "").endswith(("=delete", "=default")) or member.findtext("name").startswith("~")


def is_friend_class(member):
    return member.get("kind") == "friend" and not member.findtext("argsstring")


def members_of(compound, scope, grouped):
    for member in compound.iter("memberdef"):
        if member.get("prot") != "public" or is_friend_class(member) or is_written_by_the_compiler(member):
            continue
        name = member.findtext("qualifiedname") or scope + "::" + member.findtext("name")
        if "::internal::" in name or member.findtext("name").startswith("@"):
            continue
        yield Entity(member, name + (member.findtext("argsstring") or ""), member.get("kind"), grouped)
        for value in member.findall("enumvalue"):
            entity = Entity(value, name + "::" + value.findtext("name"), "enumerator", grouped)
            entity.place = f"{member.find('location').get('file')}:{member.find('location').get('line')}"
            yield entity


def entities(folder):
    """All public entities that the XML files in `folder` speak of."""
    compounds = [compound for path in sorted(folder.glob("*.xml")) if path.name != "index.xml"
                 for compound in ElementTree.parse(path).getroot().iter("compounddef")]
    grouped = {node.get("refid") for compound in compounds if compound.get("kind") == "group"
               for node in compound.findall("innerclass")}
    nested = {node.get("refid") for compound in compounds if compound.get("kind") in ("class", "struct")
              for node in compound.findall("innerclass")}
    found = {}
    for compound in compounds:
        kind = compound.get("kind")
        name = compound.findtext("compoundname")
        if "internal" in name.split("::"):
            continue
        if kind in ("class", "struct", "union") and compound.get("prot") == "public":
            entity = Entity(compound, name, kind, compound.get("id") in grouped | nested)
            found[(entity.name, entity.place)] = entity
            for member in members_of(compound, name, True):
                found[(member.name, member.place)] = member
        elif kind in ("group", "namespace"):
            for member in members_of(compound, name, kind == "group"):
                key = (member.name, member.place)
                if key not in found or member.is_grouped:
                    found[key] = member
    return list(found.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", required=True, type=pathlib.Path, help="a folder for doxygen's XML; is emptied")
    parser.add_argument("--source", default=make_manual.SOURCE, type=pathlib.Path, help="the checkout; default: this one")
    parser.add_argument("--doxygen", default="doxygen", help="the program")
    parser.add_argument("--list", action="store_true", help="name all entities")
    options = parser.parse_args()
    work = options.work.resolve()
    shutil.rmtree(work, ignore_errors=True)
    make_manual.run_doxygen(options.doxygen, options.source.resolve(), work, SETTINGS)
    found = entities(work / "xml")
    bad = [entity for entity in found if not (entity.is_documented and entity.is_grouped)]
    for entity in sorted(found if options.list else bad, key=lambda entity: entity.place):
        remarks = ([] if entity.is_documented else ["not documented"]) + ([] if entity.is_grouped else ["in no group"])
        print(f"{entity.place}: {entity.kind} {entity.name}" + (": " if remarks else "") + ", ".join(remarks))
    print(f"public entities: {len(found)}, documented: {sum(entity.is_documented for entity in found)}, "
          f"in a group: {sum(entity.is_grouped for entity in found)}")
    if not found:
        print("check_entities.py: no entity was found at all", file=sys.stderr)
    return 1 if bad or not found else 0


if __name__ == "__main__":
    sys.exit(main())
