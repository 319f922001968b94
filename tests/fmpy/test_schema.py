"""The schema by which editors mark aircraft files, asked by a validator of others: it takes what the program takes, and refuses what the
program refuses field by field. The cases are those of tests/aircraft/format_cases.rs, which asks the program."""

import copy
import json
import os
import subprocess
import tomllib
from pathlib import Path

import jsonschema
import pytest

ROOT = Path(__file__).parents[2]
FLEXAIR = ["cargo", "run", "--release", "--quiet", "--manifest-path", ROOT / "Cargo.toml", "--"]
if "FLEXAIR" in os.environ:
    FLEXAIR = [Path(os.environ["FLEXAIR"]).resolve()]

FILES = sorted([*ROOT.glob("aircraft/*.toml"), *ROOT.glob("tests/data/*.toml")])
DATA = ROOT / "tests/data"


@pytest.fixture(scope="module")
def validator():
    schema = json.loads(subprocess.run([*FLEXAIR, "schema"], check=True, capture_output=True, text=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def mistakes(validator, text):
    return [f"{error.json_path}: {error.message}" for error in validator.iter_errors(tomllib.loads(text))]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_aircraft_here_is_valid(validator, path):
    assert mistakes(validator, path.read_text(encoding="utf-8")) == []


def test_every_complete_example_of_the_page_is_valid(validator):
    page = (ROOT / "aircraft/README.md").read_text(encoding="utf-8")
    examples = [block.split("```")[0] for block in page.split("```toml\n")[1:]]
    complete = [example for example in examples if example.startswith("format = 1")]
    assert complete
    for example in complete:
        assert mistakes(validator, example) == []


def edited(content, edits):
    content = copy.deepcopy(content)
    for edit in edits:
        *path, last = edit["at"]
        holder = content
        for step in path:
            holder = holder[step]
        if "value" in edit:
            holder[last] = edit["value"]
        else:
            holder.pop(last, None)
    return content


def test_the_schema_refuses_what_the_program_refuses_field_by_field(validator):
    base = tomllib.loads((DATA / "every-field.toml").read_text(encoding="utf-8"))
    cases = json.loads((DATA / "format-cases.json").read_text(encoding="utf-8"))
    assert len(cases) > 300
    wrong = [case for case in cases if validator.is_valid(edited(base, case["edits"])) == case["refused"]]
    assert wrong == []
