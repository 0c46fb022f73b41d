"""Tests of the published JSON schema of the report."""

import json
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator, ValidationError

from lispac.cli.main import main
from lispac.present.json_values import NOT_IN_JSON
from lispac.project import Project
from lispac.report.content import ReportContent
from lispac.report.json_report import json_text
from lispac.workflow.output.export import write_report
from lispac.workflow.project.survey import load_survey
from tests.documents.schemas import PATH, followed, schema_text
from tests.report.test_identity import FULL
from tests.support.report_sample import sample_content, sample_project


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    found = json.loads(PATH.read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(found)
    return found  # type: ignore[no-any-return]


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("schema") / "harbour").with_identity(FULL)


def test_published_schema_is_up_to_date() -> None:
    instruction = "a content class has changed: run `python -m tests.documents`"
    assert PATH.read_text(encoding="utf-8") == schema_text(), instruction


def _has_numbers(schema: Any) -> bool:
    """Whether a schema is of a list of numbers, or of lists of them."""
    if any(map(_has_numbers, schema.get("anyOf", ()))):
        return True
    items = [schema.get("items", {}), *schema.get("prefixItems", ())]
    return schema.get("type") == "array" and any(
        item.get("type") in ("number", "integer") or _has_numbers(item) for item in items
    )


def test_all_lists_of_numbers_have_a_description(schema: dict[str, Any]) -> None:
    lists = {
        (name, field): each
        for name, definition in schema["$defs"].items()
        for field, each in definition.get("properties", {}).items()
        if _has_numbers(each)
    }
    assert ("PickedPlane", "seed_local_m") in lists
    assert not [place for place, each in lists.items() if not each.get("description")]


def test_reports_of_every_kind_are_valid(project: Project) -> None:
    thesis = sample_project(project.folder.parent / "thesis", model="independent")
    samples = (
        sample_content(project),
        sample_content(project, convention="qinsy"),
        sample_content(project, convention="pdal"),
        sample_content(thesis),
        sample_content(replace(project, result=None, validation=(), cross_checks=None)),
        sample_content(replace(project, truth_deg=(0.44, -1.87, 0.6))),
        sample_content(replace(project, trajectory=project.folder / "gone.sbet")),
    )
    for content in samples:
        data = followed(json_text(content))
        kept = {each.name for each in fields(content) if each.metadata != NOT_IN_JSON}
        assert set(data) == {"schema", "schema_version", *kept}


def test_report_of_a_survey_is_valid(demo_project: Project, tmp_path: Path) -> None:
    path = tmp_path / "r.json"
    write_report(demo_project, load_survey(demo_project), path)
    assert followed(path.read_text(encoding="utf-8"))["calibrated"] is False


def _broken(content: ReportContent) -> list[dict[str, Any]]:
    """Return invalid reports: missing keys, wrong types, unknown words."""
    found = []
    for change in (
        lambda data: data.pop("identity"),
        lambda data: data["adjustment"]["boresight_deg"].update(roll="0.4"),
        lambda data: data["adjustment"].pop("s44"),
        lambda data: data["warnings"].append(
            {"code": "x", "former_code": "x", "level": "grave", "text": "", "params": {}}
        ),
        lambda data: data["matrix"].update(transform=None),
        lambda data: data.update(schema_version=1),
    ):
        data = json.loads(json_text(content))
        change(data)
        found.append(data)
    return found


def test_invalid_reports_are_refused(project: Project, schema: dict[str, Any]) -> None:
    for data in _broken(sample_content(project)):
        with pytest.raises(ValidationError):
            Draft202012Validator(schema).validate(data)


def test_report_command_prints_the_schema_and_otherwise_needs_a_project(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["report", "--schema"]) == 0
    assert capsys.readouterr().out == PATH.read_text(encoding="utf-8")
    assert main(["report"]) == 2
    assert "give a project and --output FILE" in capsys.readouterr().err
