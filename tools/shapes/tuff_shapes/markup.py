# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# XML looked over before a library reads it: whether it is XML at all, without entities, and which elements it has.
from dataclasses import dataclass
from pathlib import Path
from xml.parsers import expat

from .faults import ShapeFault


@dataclass(frozen=True)
class Element:
    tag: str                     # without a name space
    attributes: dict[str, str]
    line: int
    inside: tuple[str, ...]      # the tags around it, outermost first


def content(path, place=""):
    """The bytes of a file."""
    try:
        return Path(path).read_bytes()
    except OSError as fault:
        raise ShapeFault(f"cannot be read: {fault.strerror}", place) from None


def is_xml(data):
    """Whether bytes are meant as XML: after a byte order mark and blanks they begin with '<'."""
    return data.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] == b"<"


def elements(data, place=""):
    """The elements of an XML file, from its bytes, in the order of their start tags."""
    found, open_tags = [], []
    parser = expat.ParserCreate()

    def begin(tag, attributes):
        tag = tag.rpartition(":")[2]
        found.append(Element(tag, attributes, parser.CurrentLineNumber, tuple(open_tags)))
        open_tags.append(tag)

    def refuse_entity(name, *_):
        # A few nested entities can stand for gigabytes, and what they stand for may lie in other files.
        raise ShapeFault(f"line {parser.CurrentLineNumber}: defines the entity '{name}'; entities are not read", place)

    parser.StartElementHandler = begin
    parser.EndElementHandler = lambda tag: open_tags.pop()
    parser.EntityDeclHandler = refuse_entity
    try:
        parser.Parse(data, True)
    except expat.ExpatError as fault:
        raise ShapeFault(f"is not XML: {expat.ErrorString(fault.code)}, line {fault.lineno}, column {fault.offset + 1}",
                         place) from None
    return found
