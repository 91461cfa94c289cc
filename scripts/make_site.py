#!/usr/bin/env python3
"""Makes the site of documentation in build/docs/html with Doxygen, and checks its links.

usage: make_site.py
       make_site.py --filter FILE   prints FILE as Doxygen shall read it; docs/Doxyfile calls this

For a header: each line that starts with `Errors:`, `Cost:` or the like starts a paragraph with this title. The codes of
errors and the names of pages become links.
For a Markdown page: each heading gets the label that GitHub gives it, and each link to a file of the project leads to its
page of the site. A link to a file that has no page becomes plain text. The name of a public class or of its member, as
code, becomes a link to the reference. Doxygen 1.9.4 does not know code in headings, nor bold
code: the first becomes plain, the second HTML.

Run it in the project's root folder.
"""

import os
import posixpath
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

DOXYFILE = "docs/Doxyfile"
TOPICS = "docs/topics.dox"
ERRORS = "include/waywright/error.hpp"
SITE = "build/docs/html"
FRONT_PAGE = "README.md"
# The pages whose links make the tree of pages.
LISTS = {"docs/README.md", "docs/benchmarks.md"}
FOLDERS = {"include/waywright": "modules.html", "examples": "examples.html", "examples/lockstep": "examples.html"}

LABELLED = re.compile(r"^(\s*///) (Requires|Errors|Cost|Source|Threads|Exceptions): ", re.MULTILINE)
FENCE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^(#+) (.+)$", re.MULTILINE)
PAGE_NAME = re.compile(r"\b(docs/[\w/]+|ARCHITECTURE)\.md\b")
CLASS = re.compile(r"^(?:enum )?(?:class|struct) (?:\[\[nodiscard\]\] )?(?:WAYWRIGHT_API\w* )?(\w+)\b(?!::|;)", re.MULTILINE)
MEMBER = re.compile(r"`(\w+)(?:::(\w+))?`")
BOLD_CODE = re.compile(r"\*\*`([^`*]+)`\*\*")
LINKED_IMAGE = re.compile(r"\[(!\[[^\]]+\]\([^)\s]+\))\]\([^)\s]+\)")  # Doxygen cannot link an image
LINK = re.compile(r"(!?)\[([^\]]+)\]\(([^)\s#]*)(?:#([^)\s]+))?\)")


def slug(heading):
    """The label that GitHub gives a heading."""
    words = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower())
    return words.strip().replace(" ", "-")


def label_of(page, anchor=None):
    name = re.sub(r"\W", "_", page.removesuffix(".md"))
    return f"{name}-{anchor}" if anchor else name


def example_page(name):
    """The file name that Doxygen gives the page of an example."""
    return name.replace(".", "_8") + "-example.html"


def error_codes(root):
    """The names in the enumeration ErrorCode."""
    body = re.search(r"^enum class ErrorCode .*?^};", (root / ERRORS).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    return re.findall(r"^  (\w+)(?: = \d+)?,", body[0], re.MULTILINE)


def filter_header(text, root=Path()):
    codes = error_codes(root)
    code = re.compile(rf"\b({'|'.join(codes)})\b")

    def errors(match):
        return code.sub(r'@ref waywright::ErrorCode::\1 "\1"', match[0])

    text = re.sub(r"^\s*/// Errors: .*$", errors, text, flags=re.MULTILINE)
    # `@file`, which makes a page of the header, comes last, so that line numbers stay.
    text = PAGE_NAME.sub(lambda match: f"[{match[0]}](@ref {label_of(match[0])})", text)
    return LABELLED.sub(r"\1 @par \2\n\1 ", text) + "/// @file\n"


def public_classes(root):
    """The names of the functions in the header of each public class, by the name of the class."""
    functions = {}
    for header in sorted((root / "include/waywright").glob("*.hpp")):
        text = header.read_text(encoding="utf-8")
        functions.update((name, set(re.findall(r"(\w+)\(", text))) for name in CLASS.findall(text))
    return functions


def filter_page(page, text, root=Path()):
    listed = set()
    classes = public_classes(root)

    def member(match):
        name, member_name = match.groups()
        if name not in classes:
            return match[0]
        target = f"{name}::{member_name}" if member_name in classes[name] else name
        return f'<code>@ref waywright::{target} "{match[0].strip("`")}"</code>'

    def label(match):
        level, heading = match.groups()
        plain = f"{level} {heading.replace('`', '')}"
        if len(level) == 1:
            return plain if page == FRONT_PAGE else f"{plain} {{#{label_of(page)}}}"
        return f"{plain} {{#{label_of(page, slug(heading))}}}"

    def link(match):
        is_image, words, path, anchor = match.groups()
        if ":" in path:
            return match[0]
        target = posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
        if is_image:
            return f"![{words}]({posixpath.basename(target)})"
        if (root / target).is_dir():
            target = FOLDERS.get(target, f"{target}/README.md")
        if target.endswith(".html"):
            return f"[{words}]({target})"
        if target == FRONT_PAGE and not anchor:
            return f"[{words}](index.html)"
        if target.endswith(".md") and (root / target).exists():
            if page in LISTS and not anchor and target not in listed:
                listed.add(target)
                return f'@subpage {label_of(target)} "{words}"'
            return f"[{words}](@ref {label_of(target, anchor)})"
        if target.startswith("include/waywright/"):
            return f"[{words}](@ref {posixpath.basename(target)})"
        name = posixpath.basename(target)
        if f"@example {name}\n" in (root / TOPICS).read_text(encoding="utf-8"):
            return f"[{words}]({example_page(name)})"
        return words

    pieces = FENCE.split(text)
    for i in range(0, len(pieces), 2):
        piece = LINK.sub(link, HEADING.sub(label, LINKED_IMAGE.sub(r"\1", pieces[i])))
        pieces[i] = MEMBER.sub(member, BOLD_CODE.sub(r"<b><code>\1</code></b>", piece))
    return "".join(pieces)


class Page(HTMLParser):
    """The labels of a page, and its links to other files of the site."""

    def __init__(self, text):
        super().__init__()
        self.labels = set()
        self.links = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.labels.update(attributes[name] for name in ("id", "name") if name in attributes)
        if tag == "a" and attributes.get("href") or tag == "img" and attributes.get("src"):
            link = attributes["href" if tag == "a" else "src"]
            if not re.match(r"[a-z]+:", link):
                self.links.append(unquote(link))


def faults_of(site):
    """Yields what is wrong with the links of the site."""
    pages = {file.name: Page(file.read_text(encoding="utf-8")) for file in sorted(site.glob("*.html"))}
    for name, page in pages.items():
        for link in page.links:
            file, _, label = link.partition("#")
            file = file or name
            if not (site / file).exists():
                yield f"{name}: the link to {link} leads nowhere"
            elif label and file in pages and label not in pages[file].labels:
                yield f"{name}: the link to {link} leads to no place on that page"


def version():
    text = Path("include/waywright/version.hpp").read_text(encoding="utf-8")
    return re.search(r'#define WAYWRIGHT_VERSION "(.+)"', text)[1]


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--filter":
        file = Path(arguments[1])
        page = posixpath.relpath(file.resolve().as_posix(), Path.cwd().as_posix())
        text = file.read_text(encoding="utf-8")
        text = filter_header(text) if file.suffix == ".hpp" else filter_page(page, text)
        sys.stdout.reconfigure(encoding="utf-8")
        print(text, end="")
        return 0
    if arguments:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    shutil.rmtree(SITE, ignore_errors=True)
    Path(SITE).mkdir(parents=True)
    environment = {**os.environ, "WAYWRIGHT_VERSION": version()}
    if subprocess.run(["doxygen", DOXYFILE], env=environment, check=False).returncode != 0:
        return 1
    faults = list(faults_of(Path(SITE)))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
