"""What is done to the pages that doxygen writes: navigation, titles, numbers of figures, an index for the search."""

import html
import json
import re
import xml.etree.ElementTree as ElementTree

REFERENCE = "PkgAnimatedMeshFeaturesRef"
# what doxygen writes for menus and trees of its own
UNUSED = ["*.png", "doc*.svg", "folder*.svg", "plus*.svg", "minus*.svg", "jquery.js", "dynsections.js", "tabs.css", "menu.js",
          "menudata.js"]


def finish(folder, tag_file, pictures):
    """Works on all pages of `folder`; `pictures` are the names of image files to keep."""
    for pattern in UNUSED:
        for path in folder.glob(pattern):
            if path.name not in pictures:
                path.unlink()
    compounds = read_compounds(tag_file)
    texts = {path.name: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.html"))}
    concepts = {name for name, text in texts.items() if 'class="amf-kind">Concept<' in text}
    figures = number_figures(texts["index.html"])
    classes = unique_classes(compounds)
    for name, text in texts.items():
        text = with_short_names(with_short_title(without_menus(text), name in concepts))
        text = with_described_pictures(text)
        for anchor, number in figures.items():
            text = text.replace(f">{anchor}</a>", f">Figure {number}</a>")
        texts[name] = with_breaks(with_links_of_classes(text, name, classes))
    parts = outline(compounds, texts)
    keep = reachable(texts, parts)
    for name, text in texts.items():
        path = folder / name
        if name not in keep:
            path.unlink()
            continue
        path.write_text(text.replace("<!-- navigation -->", navigation(parts, name)), encoding="utf-8")
    index = [entry for entry in search_index(compounds, concepts, texts) if entry[3].split("#")[0] in keep]
    (folder / "manual_index.js").write_text("var manualIndex = " + json.dumps(index, ensure_ascii=False,
                                            separators=(",", ":")).replace("],[", "],\n[") + ";\n", encoding="utf-8")


def without_menus(text):
    """The list of sections beside the title, of which some may be empty, and arrows that need a script."""
    text = re.sub(r'<div class="summary">.*?</div>', "", text, count=1, flags=re.DOTALL)
    return re.sub(r' onclick="javascript:toggleInherit[^"]*"><img src="closed.png" alt="-"/>&#160;', ">", text)


# ----------------------------------------------------------------------------------------------------------------- titles


def number_figures(manual):
    """Figures have numbers in the order of the user manual."""
    anchors = re.findall(r'class="anchor" id="(fig__[^"]*)"', manual)
    return {anchor: number for number, anchor in enumerate(dict.fromkeys(anchors), 1)}


def with_described_pictures(text):
    """Drawings as images, like photographs; captions as what is read out in the place of a picture."""
    text = re.sub(r'<object type="image/svg\+xml" data="([^"]*)"[^>]*>.*?</object>', r'<img src="\1" alt=""/>', text,
                  flags=re.DOTALL)

    def described(figure):
        caption = re.sub(r"^fig__\w+\s*|\\[()]", "", plain(figure.group(2)).partition(". ")[0])
        return figure.group(1).replace('alt=""', f'alt="{html.escape(caption, quote=True)}"') + figure.group(2)

    text = re.sub(r'(<div class="amf-figure">.*?</div>\s*)(<div class="amf-caption">.*?</div>)', described, text,
                  flags=re.DOTALL)
    return re.sub(r'(<img src="(\w+)\.\w+") alt=""',
                  lambda image: f'{image.group(1)} alt="{image.group(2).replace("_", " ")}"', text)


def with_short_title(text, is_concept):
    """"CGAL::Name< T > Class Template Reference": the scope small, the kind behind it, no parameters."""
    title = re.search(r'<div class="title">(.*?)(<div class="ingroups">|</div>)', text, re.DOTALL)
    if not title:
        return text
    words = re.fullmatch(r"\s*(.*?)\s(Class|Struct|Union|Namespace)( Template)? Reference\s*(?:<span .*</span>)?\s*",
                         title.group(1), re.DOTALL)
    example = re.fullmatch(r"\s*([\w/]+/)([\w.]+)\s*", title.group(1))
    if example:
        text = text.replace(title.group(0), title_of(*example.groups(), "example", title.group(2)), 1)
    if words:
        name = re.sub(r"&lt;.*&gt;", "", words.group(1)).strip()
        kind = "Concept" if is_concept else words.group(2) + (" template" if words.group(3) else "")
        scope, separator, last = name.rpartition("::")
        text = text.replace(title.group(0), title_of(scope + separator, last, kind.lower(), title.group(2)), 1)
        text = re.sub("<title>[^<]*(?= &ndash;)", f"<title>{last}", text, count=1)
    if is_concept:
        text = text.replace('<p class="amf-kind">Concept</p>', "")
        text = re.sub(r"\n<p><code>#include [^\n]*</code></p>", "", text, count=1)
    return text


def title_of(scope, name, kind, rest):
    return (f'<div class="title"><span class="amf-scope">{scope}</span><wbr/>{breakable(name)} '
            f'<span class="amf-kind">{kind}</span>{rest}')


def with_short_names(text):
    """Declarations without the namespace of the package, and without the class on whose page they are."""
    title = re.search(r'<span class="amf-scope">([^<]*)</span><wbr/>(\S+)', text)
    scope = re.escape("".join(title.groups()).replace("<wbr/>", "")) if title else None
    own = re.compile(rf"\b{scope}(</a>)?\s*(?:&lt;[^:]*&gt;)?::") if title else None

    def shortened(cell):
        if own:
            cell = re.sub(r'<a class="el"[^>]*></a>', "", own.sub(r"\1", cell))
        cell = re.sub(r"\bCGAL::Animated_mesh_features::", "", cell)
        # the parameters of a template are on its own page
        return re.sub(r'(<a class="el" href="(?:class|struct)[^>]*>[\w:]+)&lt;[^<]*&gt;</a>', r"\1</a>", cell)

    text = re.sub(r'<td class="(?:memname|memItemRight|memTemplItemRight|memItemLeft|memTemplItemLeft|paramtype)".*?</td>',
                  lambda cell: shortened(cell.group(0)), text, flags=re.DOTALL)
    # of constructors, which have no type
    text = re.sub(r'(<td class="mem(?:Templ)?ItemLeft"[^>]*>(?:<a id="[^>]*></a>\s*)?)&#160;</td>', r"\1</td>", text)
    return text.replace("operator()()</h2>", "operator()</h2>")


def unique_classes(compounds):
    """Pages of classes and structs, by all names that only one of them has: `Scene` and `IO::Scene`."""
    found = {}
    for name, compound in compounds.items():
        if compound.get("kind") in ("class", "struct"):
            parts = name.split("::")
            for first in range(len(parts)):
                found.setdefault("::".join(parts[first:]), set()).add(file_of(compound))
    return {name: files.pop() for name, files in found.items() if len(files) == 1}


def with_links_of_classes(text, page, classes):
    """Classes that are named in running text without their namespace, of which doxygen makes links of functions only."""

    def linked(code):
        target = classes.get(code.group(1))
        if target is None or target == page:
            return code.group(0)
        return f'<code><a class="el" href="{target}">{code.group(1)}</a></code>'

    return re.sub(r"<code>([A-Z]\w*(?:::\w+)*)</code>", linked, text)


def breakable(name):
    """A name that may be continued on the next line behind any of its words."""
    return re.sub(r"(_|::)(?=\w)", r"\1<wbr/>", name)


def with_breaks(text):
    """Names in running text and in tables."""

    def broken(part):
        return re.sub(r"(?<=>)[^<>]+(?=<)", lambda words: breakable(words.group(0)), part.group(0))

    text = re.sub(r"<code>.*?</code>", broken, text, flags=re.DOTALL)
    return re.sub(r'<td class="(?:paramname|fieldname)".*?</td>', broken, text, flags=re.DOTALL)


# ------------------------------------------------------------------------------------------------------------- navigation


def read_compounds(tag_file):
    """What doxygen's tag file says of classes, groups and pages, by name."""
    return {compound.findtext("name"): compound for compound in ElementTree.parse(tag_file).getroot().iter("compound")}


def file_of(compound):
    name = compound.findtext("filename")
    return name if name.endswith(".html") else name + ".html"


def short_name(name):
    return name.rpartition("::")[2]


def outline(compounds, texts):
    """The manual as a tree of (title, address, children)."""
    manual = []
    for level, anchor, title in re.findall(r'<h([12])><a class="anchor" id="([^"]*)"></a>\s*(.*?)</h\1>',
                                           texts["index.html"], re.DOTALL):
        entry = (plain(title), f"index.html#{anchor}", [])
        if level == "1" or not manual:
            manual.append(entry)
        else:
            manual[-1][2].append(entry)
    examples = sorted(name for name in texts if name.endswith("-example.html"))
    reference = compounds[REFERENCE]
    order = {target: rank for rank, target in
             reversed(list(enumerate(re.findall(r'href="([^"]*)"', texts[file_of(reference)]))))}
    result = [("User manual", "index.html", manual),
              ("Reference manual", file_of(reference), group_outline(compounds, reference, order)[2])]
    if examples:
        result.append(("Examples", examples[0],
                       [(example_name(texts[name]), name, []) for name in examples]))
    if "citelist.html" in texts:
        result.append(("References", "citelist.html", []))
    return result


def group_outline(compounds, group, order):
    """A group: first what is in it, in the order in which the reference page lists it, then smaller groups."""
    children = classes_of(compounds, group)
    functions = {}
    for member in group.findall("member"):
        if member.get("kind") == "function":
            functions.setdefault(short_name(member.findtext("name")) + "()", address(member))
    children += [(function, target, []) for function, target in functions.items()]
    children.sort(key=lambda child: order.get(child[1], len(order)))
    children += [group_outline(compounds, compounds[subgroup.text], order) for subgroup in group.findall("subgroup")]
    return (group.findtext("title"), file_of(group), children)


def classes_of(compounds, compound):
    """Those of a group, or those within a class."""
    return [(short_name(entry.text), file_of(compounds[entry.text]), classes_of(compounds, compounds[entry.text]))
            for entry in compound.findall("class") if entry.text in compounds]


def address(member):
    return member.findtext("anchorfile") + "#" + member.findtext("anchor")


def plain(text):
    return html.unescape(re.sub("<[^>]*>", "", text)).strip()


def example_name(text):
    return plain(re.search(r'<div class="title">.*?<wbr/>(.*?)<span', text, re.DOTALL).group(1))


def targets(parts):
    for _, target, children in parts:
        yield target
        yield from targets(children)


def reachable(texts, parts):
    """The pages to which the navigation leads, or a page to which it leads."""
    pending = [target.split("#")[0] for target in targets(parts)]
    found = set()
    while pending:
        name = pending.pop()
        if name in found or name not in texts:
            continue
        found.add(name)
        pending += re.findall(r'href="([^":#]+\.html)', texts[name])
    return found


def navigation(parts, page):
    """As a list without scripts: a part is open if it has the page."""
    return ('<input type="checkbox" id="amf-nav-switch" aria-label="Show the contents of the manual"/>'
            '<label for="amf-nav-switch" id="amf-nav-label">Contents</label>\n'
            f'<nav id="amf-nav" aria-label="Manual">{nav_list(parts, page)}</nav>')


def nav_list(parts, page):
    items = []
    for title, target, children in parts:
        is_here = target == page
        link = f'<a href="{target}"' + (' aria-current="page"' if is_here else "") + f">{breakable(html.escape(title))}</a>"
        if children:
            is_open = is_here or any(each.split("#")[0] == page for each in targets(children))
            items.append(f'<li><details{" open" if is_open else ""}><summary>{link}</summary>'
                         f"{nav_list(children, page)}</details></li>")
        else:
            items.append(f"<li>{link}</li>")
    return "<ul>" + "\n".join(items) + "</ul>"


# ----------------------------------------------------------------------------------------------------------------- search


def search_index(compounds, concepts, texts):
    """Rows of name, scope, kind, address."""
    rows = {}

    def add(name, scope, kind, target):
        rows.setdefault((name, scope.replace("CGAL::Animated_mesh_features::", ""), kind), target)

    for name, compound in compounds.items():
        kind = compound.get("kind")
        if kind in ("class", "struct"):
            target = file_of(compound)
            add(short_name(name), name.rpartition("::")[0], "concept" if target in concepts else kind, target)
        elif kind == "group":
            add(compound.findtext("title"), "", "module", file_of(compound))
        if kind in ("class", "struct", "group"):
            for member in compound.findall("member"):
                suffix = "()" if member.get("kind") == "function" else ""
                add(short_name(member.findtext("name")) + suffix, compound.findtext("title") or name,
                    member.get("kind"), address(member))
    for page, title in (("index.html", "User manual"), ("citelist.html", "References")):
        if page in texts:
            add(title, "", "page", page)
    for _, anchor, title in re.findall(r'<h([1-3])><a class="anchor" id="([^"]*)"></a>\s*(.*?)</h\1>',
                                       texts["index.html"], re.DOTALL):
        add(plain(title), "User manual", "section", f"index.html#{anchor}")
    return sorted(((*row, target) for row, target in rows.items()), key=lambda row: (row[0].lower(), row))
