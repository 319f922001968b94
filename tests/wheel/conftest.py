"""What the tests of the installed package share: they run in a copy, where neither the checkout nor cargo is."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent


@pytest.fixture
def own_aircraft(tmp_path):
    """An aircraft file of one's own."""
    return Path(shutil.copy(HERE / "small-aircraft.toml", tmp_path / "own.toml"))


@pytest.fixture
def run(tmp_path):
    """A function that runs the installed command in a folder of its own."""

    def run(*arguments, program=(Path(sys.executable).with_name("flexair"),)):
        command = [*program, *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=600)

    return run
