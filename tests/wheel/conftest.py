"""What the tests of the installed package share: they run in a copy, where neither the checkout nor cargo is."""

import re
import subprocess
import sys
from pathlib import Path

import flexair
import pytest


@pytest.fixture
def own_aircraft(tmp_path):
    """An aircraft file of one's own: the jet's under another name."""
    text = flexair.aircraft()["generic-business-jet"].read_text(encoding="utf-8")
    own = tmp_path / "own.toml"
    own.write_text(re.sub('^name = ".*"', 'name = "My aircraft"', text, count=1, flags=re.MULTILINE), encoding="utf-8")
    return own


@pytest.fixture
def run(tmp_path):
    """A function that runs the installed command in a folder of its own."""

    def run(*arguments, program=(Path(sys.executable).with_name("flexair"),)):
        command = [*program, *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=600)

    return run
