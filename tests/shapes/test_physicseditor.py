# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The exporter for PhysicsEditor, as far as it goes without PhysicsEditor: the description is well-formed, and what the template is meant
# to write compiles and passes the library's checks.
import re
import xml.etree.ElementTree as etree

import builds
import pytest

FOLDER = builds.ROOT / "tools" / "physicseditor"

# The template's loops run by hand: an L of two parts, and a circle.
EXPORTED = """#include "tuff_physicseditor.h"
static tuff_terrain rock[] = {
    TUFF_PE_OUTLINE(
        TUFF_PE_PART(TUFF_PE_POINT(-16.000, -16.000), TUFF_PE_POINT(-4.000, -16.000), TUFF_PE_POINT(-4.000, 4.000),
                     TUFF_PE_POINT(-16.000, 4.000), ),
        TUFF_PE_PART(TUFF_PE_POINT(-16.000, 4.000), TUFF_PE_POINT(-4.000, 4.000), TUFF_PE_POINT(16.000, 4.000),
                     TUFF_PE_POINT(16.000, 16.000), TUFF_PE_POINT(-16.000, 16.000), ), ),
    TUFF_PE_CIRCLE(30.000, 5.500, 4.250),
};
"""


def test_the_description_names_the_template():
    root = etree.parse(FOLDER / "tuff" / "exporter.xml").getroot()
    assert root.tag == "exporter" and (FOLDER / "tuff" / root.findtext("template")).is_file()
    assert {"name", "displayName", "version", "yAxisDirection", "physicsEngine", "fileExtension"} <= {child.tag for child in root}


def test_the_template_uses_the_macros_that_there_are_and_closes_its_blocks():
    template = (FOLDER / "tuff" / "template.txt").read_text()
    defined = set(re.findall(r"#define (TUFF_PE_\w+)", (FOLDER / "tuff_physicseditor.h").read_text()))
    assert set(re.findall(r"TUFF_PE_\w+", template)) <= defined
    for block in ("for", "if"):
        assert len(re.findall(rf"{{% {block} ", template)) == len(re.findall(rf"{{% end{block} %}}", template))


@pytest.mark.parametrize("scalar", builds.SCALARS)
def test_what_it_writes_passes_the_checks(scalar, libraries, tmp_path):
    (tmp_path / "exported.h").write_text(EXPORTED)
    program = builds.link(builds.ROOT / "tests/shapes/physicseditor.c", tmp_path / scalar, scalar, libraries[scalar],
                          f"-I{FOLDER}", f'-DEXPORTED="{tmp_path / "exported.h"}"')
    assert builds.run([program]) == "pieces 2 parts 2 internal 104\nnotch 0 corner 1 circle 1\n"
