"""The script of the README does what the README says."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

README = Path(__file__).parents[2] / "README.md"


def test_the_script_of_the_readme_draws_its_picture(fmu, tmp_path):
    [script] = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)
    packaged = tmp_path / "target" / "fmu" / "FlexibleAircraft.fmu"
    packaged.parent.mkdir(parents=True)
    shutil.copy(fmu, packaged)
    subprocess.run([sys.executable, "-c", script], cwd=tmp_path, check=True)
    assert (tmp_path / "first-flight.png").read_bytes().startswith(b"\x89PNG")
