# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Fixtures that several test files share.
import builds
import pytest


@pytest.fixture(scope="session")
def libraries(tmp_path_factory):
    """{scalar: path of the library}."""
    return builds.make_libraries(tmp_path_factory.mktemp("libraries"))


@pytest.fixture
def figures(capfd):
    """Prints a line that scripts/run-tests collects, on a line of its own between pytest's dots."""
    def show(text):
        with capfd.disabled():
            print(f"\nfigures: {text}", flush=True)
    return show
