#!/usr/bin/env python3
"""Builds the manual outside CGAL: HTML that needs no network, in OUTPUT/html.

  make_manual.py --output build/manual [--warnings-are-errors]

Needs doxygen, and MathJax 2 as Debian's libjs-mathjax installs it.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

import bibliography
import pages

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCE = FOLDER.parent.parent
MATHJAX_FOLDERS = ["/usr/share/javascript/mathjax", "/usr/share/mathjax"]
# SVG output with the TeX fonts; what it loads on demand
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element",
                 "jax/input/TeX", "jax/output/SVG/jax.js", "jax/output/SVG/config.js", "jax/output/SVG/autoload",
                 "jax/output/SVG/fonts/TeX"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", required=True, type=pathlib.Path, help="the folder to write to")
    parser.add_argument("--source", default=SOURCE, type=pathlib.Path, help="the checkout; default: this one")
    parser.add_argument("--doxygen", default="doxygen", help="the program")
    parser.add_argument("--mathjax", help="the folder of MathJax 2; default: where Debian has it")
    parser.add_argument("--warnings-are-errors", action="store_true", help="fail if doxygen has anything to say")
    return parser.parse_args()


def version(source):
    """The version in the top CMakeLists.txt, its one place."""
    text = (source / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(Animated_mesh_features\s+VERSION\s+([\d.]+)", text).group(1)


def find_mathjax(given):
    for folder in [given] if given else MATHJAX_FOLDERS:
        if (pathlib.Path(folder) / MATHJAX_PARTS[1]).exists():
            return pathlib.Path(folder)
    sys.exit("make_manual.py: MathJax 2 is not here (Debian: libjs-mathjax)")


def copy_mathjax(mathjax, target):
    for part in MATHJAX_PARTS:
        if (mathjax / part).is_dir():
            shutil.copytree(mathjax / part, target / part)
        elif (mathjax / part).exists():
            (target / part).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(mathjax / part, target / part)


def configure(template, target, values):
    """What CMake's configure_file() does to CGAL's Doxyfile.in."""
    text = template.read_text(encoding="utf-8")
    text = re.sub(r"\$\{(\w+)\}", lambda name: str(values[name.group(1)]), text)
    target.write_text(text, encoding="utf-8")


def run_doxygen(doxygen, source, output, settings=""):
    """Writes to the folder `output`, with more `settings` that come last. Returns the warnings."""
    output.mkdir(parents=True, exist_ok=True)
    values = {
        "CGAL_DOC_VERSION": "",
        "CGAL_DOC_PACKAGE_DEFAULTS": output / "defaults.doxy",
        "CGAL_PACKAGE_DIR": source,
        "CGAL_PACKAGE_DOC_DIR": source / "doc/Animated_mesh_features",
        "CGAL_PACKAGE_INCLUDE_DIR": source / "include",
        "MANUAL_DIR": source / "doc/manual",
        "MANUAL_OUTPUT_DIR": output,
    }
    package = source / "doc/Animated_mesh_features"
    bibliography.make(package / "animated_mesh_features.bib", output / "references.txt", output / "references.doxy")
    configure(source / "doc/manual/defaults.doxy.in", output / "defaults.doxy", values)
    configure(package / "Doxyfile.in", output / "package.doxy", values)
    (output / "manual.doxy").write_text(
        f'@INCLUDE = "{output}/package.doxy"\n'
        'PROJECT_NAME = "Animated_mesh_features"\n'
        f"PROJECT_NUMBER = {version(source)}\n"
        # its own list of references, without BibTeX
        "CITE_BIB_FILES =\n"
        # benchmark/Animated_mesh_features/write_page.py makes it; the user manual refers to it if it is there
        + ("ENABLED_SECTIONS = AmfPerformancePage\n" if (package / "Performance.txt").exists() else "")
        + settings, encoding="utf-8")
    log = output / "warnings.log"
    log.unlink(missing_ok=True)
    result = subprocess.run([doxygen, output / "manual.doxy"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{result.stdout}\n{doxygen} failed")
    text = result.stdout + (log.read_text(encoding="utf-8") if log.exists() else "")
    return [line for line in text.splitlines() if line.strip()]


def main():
    options = arguments()
    output = options.output.resolve()
    source = options.source.resolve()
    mathjax = find_mathjax(options.mathjax)
    shutil.rmtree(output / "html", ignore_errors=True)
    warnings = run_doxygen(options.doxygen, source, output)
    copy_mathjax(mathjax, output / "html/mathjax")
    figures = source / "doc/Animated_mesh_features/fig"
    pages.finish(output / "html", output / "Animated_mesh_features.tag", {path.name for path in figures.glob("*")})
    for warning in warnings:
        print(os.path.relpath(warning) if warning.startswith("/") else warning)
    print(f"{output}/html/index.html: {len(warnings)} warnings")
    return 1 if warnings and options.warnings_are_errors else 0


if __name__ == "__main__":
    sys.exit(main())
