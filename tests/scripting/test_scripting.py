"""Tests of the Python API `import lispac`, which has the steps of the window."""

import ast
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import lispac
from lispac.cli.main import main
from lispac.project import Project
from lispac.value_conversion import encode_value
from lispac.workflow.planning.demo import demo_seeds
from tests.support.command_errors import is_refusal
from tests.support.long_runs import LONG

CHECKOUT = Path(__file__).resolve().parents[2]
MANUAL = CHECKOUT / "resources" / "manual"
TRUTH = (0.27, -1.14, 0.36)


@pytest.fixture
def quay(demo_project: Project, tmp_path: Path) -> lispac.OpenProject:
    """The built-in survey as a new project without targets."""
    raw = demo_project.folder / "raw"
    return lispac.new(
        tmp_path / "quay",
        lines=sorted(raw.glob("*.laz")),
        trajectory=raw / "trajectory.sbet",
        accuracy=str(raw / "smrmsg.out"),
        lever_arm=(-0.242, 0.061, 2.173),
        origin_deg_m=(45.5189, -73.5390, -25.6),
        lidar_sigma=0.0017,
    )


def seed_targets(quay: lispac.OpenProject, *names: str) -> lispac.OpenProject:
    for name in names:
        role, place = demo_seeds()[name]
        quay.seed(name, place, role=role)
    return quay


def test_every_public_name_exists_and_is_typed() -> None:
    tree = ast.parse((CHECKOUT / "lispac" / "__init__.py").read_text(encoding="utf-8"))
    (typed,) = (node for node in tree.body if isinstance(node, ast.If))
    typed_names = {
        alias.asname or alias.name: node.module
        for node in ast.walk(typed) if isinstance(node, ast.ImportFrom) for alias in node.names
    }  # fmt: skip
    assert typed_names == lispac._MODULE_OF_NAME
    for name in lispac.__all__:
        assert getattr(lispac, name) is not None
        assert name in dir(lispac)
        assert not (CHECKOUT / "lispac" / name).exists(), f"{name} hides a subpackage"
    with pytest.raises(AttributeError, match="no attribute 'seeed'"):
        lispac.seeed  # noqa: B018


@LONG
def test_steps_give_the_results_of_the_command_line(
    quay: lispac.OpenProject, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = quay.project.folder
    for name in ("T1", "T2", "V1"):
        role, place = demo_seeds()[name]
        words = ["pick", folder, "--name", name, "--role", role, "--seed", *place]
        assert main([str(word) for word in words]) == 0
    assert main(["estimate", str(folder)]) == 0
    assert main(["validate", str(folder)]) == 0
    capsys.readouterr()
    typed = lispac.open(folder)

    seed_targets(quay, "T1", "T2", "V1")
    quay.estimate()
    (plane,) = quay.validate()

    assert quay.result.boresight.tolist() == typed.result.boresight.tolist()
    assert quay.result.covariance.tolist() == typed.result.covariance.tolist()
    assert encode_value(plane) == encode_value(typed.project.validation[0])
    assert (np.abs(np.array(quay.boresight_deg) - TRUTH) < 3 * np.array(quay.sigma_deg)).all()


@pytest.mark.long
@pytest.mark.parametrize(
    ("language", "pattern"),
    [
        ("en", r"(?:roll|pitch|yaw) +(\S+) deg, 1 sigma (\S+)"),
        pytest.param(
            "fr", r"(?:roulis|tangage|lacet) +(\S+)°, écart-type (\S+)", marks=pytest.mark.long
        ),
    ],
    ids=["en", "fr"],
)
def test_the_example_of_the_manual_runs(language: str, pattern: str, tmp_path: Path) -> None:
    text = (MANUAL / language / "scripts.md").read_text(encoding="utf-8")
    example, other = re.findall(r"```python\n(.*?)```", text, re.S)
    ast.parse(other)
    done = subprocess.run(
        [sys.executable, "-c", example], cwd=tmp_path, capture_output=True, encoding="utf-8",
        check=False,
        env={
            "PYTHONPATH": str(CHECKOUT), "HOME": str(tmp_path), "PYTHONUTF8": "1",
            # Use the compiled code of the other tests.
            **{name: os.environ[name] for name in ("NUMBA_CACHE_DIR",) if name in os.environ},
        },
        timeout=300,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("points") == 6
    printed = re.findall(pattern, done.stdout)
    for (value, sigma), truth in zip(printed, TRUTH, strict=True):
        assert abs(float(value) - truth) < 3 * float(sigma) + 1e-4
    report = json.loads((tmp_path / "quay.json").read_text(encoding="utf-8"))
    assert report["identity"]["vessel"] == "Saucier"
    assert (tmp_path / "quay.pdf").read_bytes().startswith(b"%PDF")
    assert lispac.open(tmp_path / "quay").project.target("T2").sighting("L3_045").used is False


@LONG
def test_edits_of_targets_through_the_api(quay: lispac.OpenProject, tmp_path: Path) -> None:
    seed_targets(quay, "T1", "V1")
    before = quay.project
    quay.reject("T1", "L1_000")
    assert quay.project.target("T1").used_sightings[0].line == "L2_180"
    quay.use("T1", "L1_000")
    quay.reject("T1")
    assert quay.project.target("T1").used_sightings == ()
    quay.project = before
    quay.rename("V1", "Tower")
    quay.set_role("Tower", "target")
    quay.set_role("Tower", "target")
    assert [(t.name, t.role) for t in quay.project.targets] == [
        ("T1", "target"), ("Tower", "target")
    ]  # fmt: skip
    quay.remove("T1")
    quay.identity(vessel=" Saucier ")
    assert quay.project.identity.vessel == "Saucier"
    quay.change(lidar_sigma=0.002)
    assert quay.survey is quay.survey
    survey = quay.survey
    quay.change(boresight_deg=(1.0, 0.0, 0.0))
    assert quay.survey is not survey
    quay.save()
    assert lispac.open(quay.project.folder).project.settings == quay.project.settings
    quay.save_as(tmp_path / "other")
    assert quay.project.name == "other"
    (path,) = quay.export("trajectory", tmp_path / "track.txt", form="text")
    assert path.stat().st_size > 1000


def test_a_point_of_a_line_can_be_a_seed(quay: lispac.OpenProject) -> None:
    target = seed_targets(quay, "T1").project.target("T1")
    sighting = target.sighting("L2_180")
    number = int(sighting.indices[len(sighting.indices) // 2])
    clicked = quay.seed("T1", point=("L2_180", number))
    assert clicked.seed == pytest.approx(quay.survey.clouds["L2_180"][np.array([number])][0])
    shared = np.intersect1d(clicked.sighting("L2_180").indices, sighting.indices)
    assert len(shared) > 0.95 * len(sighting.indices)


@pytest.mark.long
def test_proposed_targets_are_accepted(quay: lispac.OpenProject) -> None:
    proposal = quay.propose()
    names = [target.name for target in proposal.targets if target.role == "target"]
    assert quay.accept(proposal, names) == tuple(names)
    assert len(quay.accept(proposal)) == len(proposal.targets)


@pytest.mark.parametrize(
    ("step", "code"),
    [
        (lambda quay: quay.seed("T9", (500.0, 500.0, 500.0)), "finder.no_plane_in_lines"),
        (lambda quay: quay.seed("T9"), "script.place_or_point"),
        (lambda quay: quay.seed("T9", (0, 0, 0), point=("L1_000", 1)), "script.place_or_point"),
        (lambda quay: quay.seed("T9", point=("L1_000", 10**9)), "pick.no_such_point"),
        (lambda quay: quay.seed("T9", point=("L1_000", -1)), "pick.no_such_point"),
        (lambda quay: quay.seed("T9", point=("L9", 1)), "project_line.not_found"),
        (lambda quay: quay.reject("T1", "L9"), "script.no_sighting"),
        (lambda quay: quay.change(lidar_sigma=-1.0), "settings.zero_lidar_sigma"),
        (lambda quay: quay.rename("T1", ""), "edit.no_name"),
        (lambda quay: quay.estimate(), "estimate.one_line"),
        (lambda quay: quay.validate(), "project.not_estimated"),
        (lambda quay: quay.check("nothing.csv"), "estimate.needed"),
        (lambda quay: quay.report("report.doc"), "report.ending"),
        (lambda quay: quay.export("lines", "map", form="csv"), "script.unknown_export_format"),
        (lambda quay: quay.boresight_deg, "project.not_estimated"),
    ],
)
def test_refused_steps_change_nothing(opened, step, code: str) -> None:
    before = opened.project
    with pytest.raises(lispac.LispacError) as raised:
        step(opened)
    assert is_refusal(raised.value, code)
    assert opened.project is before


@pytest.fixture(scope="module")
def opened(demo_project: Project) -> lispac.OpenProject:
    """A project with one target on one line, which has no result; tests must not change it."""
    quay = lispac.open(demo_project.folder)
    quay.seed("T1", demo_seeds()["T1"][1], line="L1_000")
    return quay


def test_points_are_put_only_on_the_line_they_belong_to(opened: lispac.OpenProject) -> None:
    (sighting,) = opened.project.target("T1").sightings

    def target(line: str, numbers: str, fingerprint: str) -> lispac.Target:
        points = lispac.point_numbers(numbers)
        put = lispac.PickedSighting(line, points, rms=0.002, fingerprint=fingerprint)
        return lispac.Target("T2", "target", (0.0, 0.0, 0.0), 0.01, 2.0, (put,))

    before = opened.project
    for wrong, code in (
        (target("L9", "0+40", ""), "project_line.not_found"),
        (target("L1_000", "999999999+40", ""), "pick.no_such_point"),
        (target("L1_000", "0+40", "another"), "pick.points_changed"),
    ):
        with pytest.raises(lispac.LispacError) as raised:
            opened.put(wrong)
        assert raised.value.code == code
    assert opened.project is before
    opened.put(target("L1_000", "0+40", sighting.fingerprint))
    assert len(opened.project.target("T2").sightings[0].indices) == 40
    opened.project = before


def test_wrong_arguments_raise_the_usual_python_errors(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match="lidar_sigm"):
        lispac.new(tmp_path, lines=[], trajectory="t", lever_arm=(0, 0, 0), lidar_sigm=1.0)
    with pytest.raises(lispac.LispacError) as raised:
        lispac.new(tmp_path / "p", lines=[], trajectory="t", lever_arm=(0, 0, 0))
    assert raised.value.code == "project_line.none"
    assert not (tmp_path / "p").exists()
