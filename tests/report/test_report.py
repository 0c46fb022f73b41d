"""Tests of the numbers and warnings of the report, and that all file formats agree."""

import base64
import csv
import hashlib
import json
import re
import shutil
import subprocess
import zipfile
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.duplicate_targets import lidar_noise_notes
from lispac.errors import InputError, LispacError
from lispac.gui.appearance.colour_schemes import LIGHT_SCHEME
from lispac.message_texts import message_text
from lispac.messages import Level, note
from lispac.present.calibration.adjustment import TOO_SMALL_RAISED_TEXT, adjustment_values
from lispac.present.calibration.adjustment_fit import points_used_text
from lispac.present.targets.sightings import sighting_values
from lispac.project import Project
from lispac.report import figures
from lispac.report.content import ReportContent
from lispac.report.csv_tables import write_tables
from lispac.report.document import report_document
from lispac.report.histograms import histogram_figure
from lispac.report.html import html_text, write_html
from lispac.report.json_report import write_json
from lispac.report.pdf import write_pdf
from lispac.warning_causes import Cause
from lispac.workflow.checking.warnings import warnings_of
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long
from tests.support.report_sample import FULL_REPORT, sample_content, sample_project

SPECIAL_CHARACTERS = (
    "<script>alert(1)</script> #pagebreak() $x^2$ *b* _u_ \\n \"q\" 'a' & @ref `c` Québec Ωμ"
)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("report") / "harbour 2025")


@pytest.fixture(scope="module")
def content(project: Project) -> ReportContent:
    return sample_content(project)


def _codes(content: ReportContent) -> set[str]:
    return {message.code for message in content.warnings}


def _pdf_text(path: Path, *options: str) -> str:
    tool = shutil.which("pdftotext")
    if tool is None:
        pytest.skip("pdftotext is not installed")
    run = subprocess.run(
        [tool, "-layout", *options, str(path), "-"], check=True, capture_output=True, timeout=60
    )
    return run.stdout.decode("utf-8").replace("\u2212", "-")


def _has(text: str, number: str) -> bool:
    return re.search(rf"(?<![\d.,]){re.escape(number)}(?![\d])", text) is not None


class _Words(HTMLParser):
    """Parser that collects the visible text of a page and the addresses it would load."""

    def __init__(self) -> None:
        super().__init__()
        self.words: list[str] = []
        self.sources: list[str] = []
        self.tags: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.sources += [value or "" for name, value in attrs if name in ("src", "href")]

    def handle_data(self, data: str) -> None:
        self.words.append(data)


def _page(text: str) -> _Words:
    page = _Words()
    page.feed(text)
    return page


def _shown_numbers(data: dict) -> list[str]:
    """Return the numbers of a JSON report as documents print them."""
    numbers = []
    adjustment = data["adjustment"]
    for key in ("prior_boresight_deg", "boresight_deg"):
        numbers += [f"{value:+.4f}" for value in adjustment[key].values()]
    for key in ("sigma_deg", "interval95_deg"):
        numbers += [f"{value:.4f}" for value in adjustment[key].values()]
    numbers += [f"{value:+.3f}" for row in adjustment["correlation"] for value in row]
    numbers += [f"{adjustment['variance_factor']:.4f}", f"{adjustment['points']:,}"]
    test = adjustment["chi_square"]
    numbers += [f"{test[key]:,.1f}" for key in ("statistic", "lower", "upper")]
    numbers += [f"{100 * v:.2f}" for e in adjustment["effects"] for v in e["displacement_m"]]
    numbers += [
        f"{100 * at[key]:.2f}" for at in adjustment["s44"] for key in ("thu95_m", "tvu95_m")
    ]
    for each in data["swath_overlap"]:
        numbers += [f"{1000 * each[f'rmsd_{when}_m']:,.1f}" for when in ("before", "after")]
        numbers.append(f"{each['places']:,}")
    numbers += [f"{value:.10f}" for row in data["matrix"]["transform"] for value in row]
    fits = [*adjustment["targets"], *adjustment["sightings"]]
    numbers += [f"{1000 * fit[f'rms_{w}_m']:.1f}" for fit in fits for w in ("before", "after")]
    numbers += [f"{1000 * s['mean_after_m']:+.1f}" for s in adjustment["sightings"]]
    for extra in adjustment["parameters"]:
        numbers += [f"{extra[key]:+.4f}" for key in ("prior", "value")]
        numbers += [f"{extra['sigma']:.4f}", f"{extra['significance']:+.1f}"]
    without = adjustment["observability"]["sigma_without_line_deg"]
    numbers += [f"{v:.4f}" for sigma in without.values() for v in (sigma or {}).values()]
    for sighting in adjustment["sightings"]:
        numbers += [f"{1000 * sighting['shift_m']:+.1f}", f"{sighting['w']:+.2f}"]
        numbers += [f"{1000 * sighting['detectable_m']:.1f}", f"{sighting['redundancy']:.2f}"]
        numbers += [f"{v:+.4f}" for v in sighting["effect_deg"].values()]
        numbers += [f"{v:+.4f}" for v in sighting["pos_error"]["error_deg"]]
        north, west, up = sighting["pos_error"]["error_m"]
        numbers += [f"{1000 * v:+.1f}" for v in (-west, north, up)]  # east, north, up
    for part in data["cross_checks"]["parts"]:
        numbers += [f"{v:+.4f}" for v in (part["difference_deg"] or {}).values()]
        numbers += [f"{v:+.1f}" for v in (part["significance"] or {}).values()]
    for plane in data["validation"]:
        for state in (plane["before"], plane["after"]):
            keys = ("mean", "median", "rms", "p68", "p95", "p99", "robust_sigma")
            numbers += [f"{1000 * state[f'{key}_m']:,.1f}" for key in keys]
            numbers += [f"{state['n']:,}", f"{state['outliers']:,}"]
        for pair in plane["pairs"]:
            for state in (pair["before"], pair["after"]):
                found = state["distances"]
                numbers += [f"{1000 * found[f'{key}_m']:,.1f}" for key in ("median", "rms", "p95")]
                numbers.append(f"{found['n']:,}")
                numbers += _signed_numbers(state["signed"], state["planes"])
    numbers += [f"{file['size_bytes']:,}" for file in data["files"]]
    # A number that is rounded to zero has no sign.
    return [n if float(n.replace(",", "")) else n.strip("+-") for n in numbers]


def _signed_numbers(places: dict, planes: dict) -> list[str]:
    return [
        f"{1000 * places['median_m']:+.1f}",
        f"{1000 * places['interval95_m']:.1f}",
        f"{100 * places['significant_share']:.0f}",
        f"{1000 * planes['offset_m']:+.1f}",
        f"{1000 * planes['offset_interval95_m']:.1f}",
        f"{planes['rotation_horizontal_axis_deg']:+.3f}",
        f"{planes['rotation_slope_axis_deg']:+.3f}",
        f"{planes['rotation_slope_axis_interval95_deg']:.3f}",
    ]


def test_report_has_angles_uncertainties_and_effects(content: ReportContent) -> None:
    roll, pitch, yaw = content.angles
    assert roll.estimated_deg == pytest.approx(0.43951)
    assert pitch.sigma_deg == pytest.approx(0.0291)
    assert yaw.interval95_deg == pytest.approx(1.96 * 0.0376)
    assert content.adjustment is not None
    effects = {effect.angle: effect.displacement_m for effect in content.adjustment.effects}
    assert effects["roll"] == pytest.approx([d * np.radians(0.0163) for d in (10, 50, 100)])
    # Sampled: the largest displacement of points 10 m away in all directions.
    rng = np.random.default_rng(3)
    covariance = np.radians(0.0163), np.radians(0.0291), np.radians(0.0376)
    correlation = np.array(content.adjustment.correlation)
    turns = rng.multivariate_normal(
        np.zeros(3), correlation * np.outer(covariance, covariance), 4000
    ) * [1, 1, -1]  # yaw is clockwise
    directions = rng.normal(size=(300, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    moves = np.linalg.norm(np.cross(turns[:, None], 10 * directions[None]), axis=2)
    worst = np.sqrt((moves**2).mean(axis=0)).max()
    assert effects["worst direction"][0] == pytest.approx(worst, rel=0.04)


def test_files_are_identified_by_digest(content: ReportContent, project: Project) -> None:
    line = next(file for file in content.files if file.role == "Line L3")
    data = project.lines[2].path.read_bytes()
    assert (line.name, line.size_bytes) == ("L3.laz", len(data))
    assert line.sha256 == hashlib.sha256(data).hexdigest()


def test_a_missing_file_gives_a_warning_in_the_report(project: Project, tmp_path: Path) -> None:
    moved = replace(project, trajectory=tmp_path / "gone.sbet")
    content = sample_content(moved)
    assert content.files[0].sha256 is None
    assert "report.file_missing" in _codes(content)
    assert "not readable" in html_text(content, {}, FULL_REPORT)


def test_finished_project_has_no_warnings(content: ReportContent) -> None:
    assert content.warnings == ()


def test_each_rule_of_the_report_gives_its_warning(project: Project) -> None:
    result = project.result
    assert result is not None
    test = result.chi_square
    high = replace(result, chi_square=replace(test, statistic=test.upper * 1.1))
    low = replace(result, chi_square=replace(test, statistic=test.lower * 0.9))
    none = replace(result, degrees_of_freedom=0, variance_factor=float("nan"))
    assert "report.chi_square_high" in _codes(sample_content(replace(project, result=high)))
    assert "report.chi_square_low" in _codes(sample_content(replace(project, result=low)))
    assert "report.no_redundancy" in _codes(sample_content(replace(project, result=none)))
    thesis = replace(result, model=StochasticModel("independent"))
    assert "adjustment.independent_pos_errors" in _codes(
        sample_content(replace(project, result=thesis))
    )
    assert "report.not_validated" in _codes(sample_content(replace(project, validation=())))
    plane = project.validation[0]
    worse = replace(plane, before=plane.after, after=plane.before)
    found = sample_content(replace(project, validation=(worse,)))
    assert "report.validation_worse" in _codes(found)
    assert found.warnings[0].level is Level.WARNING


def _small_residuals(project: Project, **changes: Any) -> Project:
    """Project whose residuals show half the given LiDAR noise."""
    result = project.result
    assert result is not None
    test = replace(result.chi_square, statistic=result.chi_square.lower * 0.9)
    return replace(
        project,
        settings=replace(project.settings, lidar_sigma=0.005),
        result=replace(result, chi_square=test, lidar_noise_ratio=0.5, **changes),
    )


def test_one_note_says_what_a_smaller_noise_means_for_the_sigmas(project: Project) -> None:
    content = sample_content(_small_residuals(project))
    (noise,) = content.warnings
    assert (noise.code, noise.level) == ("adjustment.lidar_noise_conservative", Level.NOTE)
    given = project.settings.used_lidar_sigma
    assert noise.params == {"given": given, "measured": pytest.approx(given / 2)}
    (action,) = noise.actions
    assert (action.code, action.params) == (
        "use_lidar_noise",
        {"given": given, "measured": given / 2},
    )
    assert noise.subject == Cause.of_field("lidar_sigma")
    beam = replace(project.settings, lidar_beam_sigma=(0.01, 0.05))
    (noise,) = sample_content(replace(_small_residuals(project), settings=beam)).warnings
    assert noise.code == "adjustment.lidar_noise_ratio_conservative"
    assert noise.params == {"ratio": 0.5}


@pytest.mark.parametrize(
    ("ratio", "code"),
    [
        (0.5, "adjustment.lidar_noise_assumed_conservative"),
        (2.0, "adjustment.lidar_noise_assumed"),
    ],
)
def test_an_assumed_lidar_noise_is_not_called_given(
    project: Project, ratio: float, code: str
) -> None:
    settings = replace(project.settings, lidar_sigma=None, lidar_beam_sigma=None)
    small = _small_residuals(project)
    assert small.result is not None
    changed = replace(
        small, settings=settings, result=replace(small.result, lidar_noise_ratio=ratio)
    )
    (noise,) = lidar_noise_notes(changed)
    assert noise.code == code
    assert noise.params == {"given": 0.005, "measured": pytest.approx(ratio * 0.005)}


def test_raised_sigmas_are_not_said_to_be_too_large(project: Project) -> None:
    raised = _small_residuals(project, angle_sigma_factors=np.array([1.0, 2.5, 1.0]))
    codes = [each.code for each in sample_content(raised).warnings]
    assert codes == ["adjustment.sigmas_raised_conservative", "adjustment.lidar_noise"]
    also = [each.code for each in warnings_of(raised, None)]
    assert set(codes) <= set(also)
    assert not {"report.chi_square_low", "adjustment.sigmas_raised"} & set(also)
    assert raised.result is not None
    assert str(adjustment_values(raised.result).chi_square.text) == TOO_SMALL_RAISED_TEXT


def test_the_points_used_and_those_picked_are_given(project: Project) -> None:
    content = sample_content(project)
    assert content.adjustment is not None
    assert content.adjustment.picked_points == sum(
        len(s.indices) for t in project.targets if t.role == "target" for s in t.sightings
    )
    many = replace(content.adjustment, points=2_088, picked_points=22_517, excluded_outliers=3)
    assert re.findall(r"\d[\d,]*\b", points_used_text(many)) == ["2,088", "22,517", "3"]
    all_used = replace(many, picked_points=2_088, excluded_outliers=0)
    assert points_used_text(all_used) == "2,088"


def test_targets_seen_on_few_lines_give_a_warning(project: Project) -> None:
    first, second, *rest = project.targets
    few = replace(first, sightings=first.sightings[:1], missing={"L2": note("finder.not_alike")})
    some = replace(second, sightings=second.sightings[:2])
    content = sample_content(replace(project, targets=(few, some, *rest)))
    codes = [each.code for each in content.warnings if "T1" in message_text(each)]
    assert codes == ["targets.single_line_targets", "report.not_found"]
    (few,) = [each for each in content.warnings if each.code == "report.target_on_few_lines"]
    assert (few.params["target"], few.params["count"], few.params["total"]) == ("T2", 2, 6)
    html = html_text(content, {}, FULL_REPORT)
    (missing,) = [each for each in content.warnings if each.code == "report.not_found"]
    reason = note("finder.not_alike")
    assert missing.params["reason"] == reason
    assert missing.params["items"] == (note("report.not_found_on", target="T1", lines=("L2",)),)
    assert message_text(reason) in html


def test_truth_of_a_simulated_survey_is_reported(project: Project) -> None:
    content = sample_content(replace(project, truth_deg=(0.44, -1.87, 0.6)))
    assert content.angles[0].error_deg == pytest.approx(0.43951 - 0.44)
    assert {"report.simulated", "report.truth_outside"} <= _codes(content)
    outside = next(c for c in content.warnings if c.code == "report.truth_outside")
    assert note("quantity.yaw") in outside.params["angles"]
    assert note("quantity.roll") not in outside.params["angles"]


def test_json_has_full_precision(content: ReportContent, tmp_path: Path) -> None:
    path = tmp_path / "report.json"
    write_json(content, path)
    data = json.loads(path.read_text(encoding="utf-8"))
    assert data["schema_version"] == 11
    assert content.adjustment is not None
    assert data["adjustment"]["boresight_deg"]["pitch"] == content.adjustment.boresight_deg.pitch
    assert data["adjustment"]["rms_after_m"] == content.adjustment.rms_after_m
    assert data["validation"][2]["after"]["p95_m"] == content.validation[2].after.p95_m


def test_pdf_and_html_show_the_numbers_of_the_json(content: ReportContent, tmp_path: Path) -> None:
    write_json(content, tmp_path / "r.json")
    numbers = _shown_numbers(json.loads((tmp_path / "r.json").read_text(encoding="utf-8")))
    assert len(numbers) > 400
    page = " ".join(_page(html_text(content, {}, FULL_REPORT)).words).replace("\u2212", "-")
    assert [n for n in numbers if not _has(page, n)] == []
    write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
    text = _pdf_text(tmp_path / "r.pdf")
    assert [n for n in numbers if not _has(text, n)] == []
    for file in content.files:
        assert file.sha256 is not None
        assert file.sha256 in text
    assert "Page 1 of" in text


def test_tables_have_the_numbers_of_the_json(content: ReportContent, tmp_path: Path) -> None:
    write_json(content, tmp_path / "r.json")
    data = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    write_tables(content, tmp_path / "r.zip")
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        names = archive.namelist()
        tables = {
            name: list(csv.reader(archive.read(name).decode("utf-8-sig").splitlines()))
            for name in names
        }
    assert names == sorted(names)
    assert len(names) > 10
    boresight = tables["02-boresight.csv"]
    assert boresight[0][:3] == ["Angle", "Prior (°)", "Estimated (°)"]
    for row, name in zip(boresight[1:], ("roll", "pitch", "yaw"), strict=True):
        assert float(row[2]) == pytest.approx(data["adjustment"]["boresight_deg"][name], abs=5e-5)
        assert float(row[4]) == pytest.approx(data["adjustment"]["interval95_deg"][name], abs=5e-5)
    (pairs,) = (rows for name, rows in tables.items() if "every-pair-of-lines" in name)
    listed = [pair for plane in data["validation"] for pair in plane["pairs"]]
    for row, pair in zip(pairs[1:], listed, strict=True):
        assert int(row[3]) == pair["before"]["distances"]["n"]
        assert float(row[7]) == pytest.approx(1000 * pair["after"]["distances"]["rms_m"], abs=0.05)
    lengths = {
        title
        for rows in tables.values()
        for title in rows[0]
        if title.startswith(("Median", "RMS", "Offset", "Shift (", "at 1"))
    }
    assert {"Median before (mm)", "RMS after (mm)", "at 100 m (cm)"} <= lengths
    assert all(title.endswith(("(mm)", "(cm)")) for title in lengths), lengths
    again = tmp_path / "again.zip"
    write_tables(content, again)
    assert again.read_bytes() == (tmp_path / "r.zip").read_bytes()


def test_the_verdict_states_that_a_calibration_is_not_validated(project: Project) -> None:
    compared = report_document(sample_content(project), {}, FULL_REPORT)
    assert "NOT VALIDATED" not in compared.verdict
    alone = sample_content(replace(project, validation=()))
    document = report_document(alone, {}, FULL_REPORT)
    assert document.verdict == "CALIBRATED, WITH NOTES – NOT VALIDATED"
    assert document.status == "fair"


@pytest.mark.parametrize("picked", others_long([True, False]))
def test_page_one_states_that_a_project_is_not_calibrated(
    project: Project, tmp_path: Path, picked: bool
) -> None:
    bare = replace(project, result=None, validation=())
    content = sample_content(bare if picked else replace(bare, targets=()))
    assert content.warnings[0].code == "report.not_calibrated"
    assert _page(html_text(content, {}, FULL_REPORT)).words[:30].count("NOT CALIBRATED") == 1
    write_json(content, tmp_path / "r.json")
    assert json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["calibrated"] is False
    write_pdf(content, tmp_path / "r.pdf", {}, FULL_REPORT)
    first = _pdf_text(tmp_path / "r.pdf", "-f", "1", "-l", "1")
    assert "NOT CALIBRATED" in first
    pages = re.findall(r"Page (\d) of (\d)", _pdf_text(tmp_path / "r.pdf"))
    assert len(pages) > 2
    assert pages == [(str(k), str(len(pages))) for k in range(1, len(pages) + 1)]
    assert "Estimated" not in first


def test_html_loads_no_other_files(content: ReportContent, tmp_path: Path) -> None:
    picture = tmp_path / "view.png"
    figures.site_figure({}, {"T1": (1.0, 2.0)}, {}).savefig(picture, dpi=40)
    path = tmp_path / "report.html"
    write_html(content, path, {"The view after": picture}, FULL_REPORT)
    text = path.read_text(encoding="utf-8")
    page = _page(text)
    assert not re.search(r"https?://|url\(|@import", text)
    assert page.tags.isdisjoint({"script", "link", "iframe", "object"})
    assert page.sources
    assert all(source.startswith(("data:image/", "#")) for source in page.sources)
    assert base64.b64encode(picture.read_bytes()).decode() in text
    assert "The view after" in page.words


@LONG
def test_special_characters_in_names_are_kept(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p", target=SPECIAL_CHARACTERS)
    content = sample_content(project)
    content = replace(content, project=SPECIAL_CHARACTERS)
    page = _page(html_text(content, {}, FULL_REPORT))
    assert page.words.count(SPECIAL_CHARACTERS) >= 3
    assert "script" not in page.tags
    path = tmp_path / "odd.pdf"
    write_pdf(content, path, {}, FULL_REPORT)
    # Long words may be broken, and a long cell into lines.
    text = re.sub(r"[\s\u200b]", "", _pdf_text(path, "-raw"))
    assert text.count(re.sub(r"\s", "", SPECIAL_CHARACTERS)) >= 3


def test_letters_missing_in_the_fonts_do_not_fail(content: ReportContent, tmp_path: Path) -> None:
    far = replace(content, project="\u6e2f\u53e3", validation=content.validation[:1])
    far = replace(far, validation=(replace(far.validation[0], name="\u5854"),))
    write_pdf(far, tmp_path / "far.pdf", {}, FULL_REPORT)
    assert (tmp_path / "far.pdf").stat().st_size > 10_000


def test_data_of_the_figures_are_among_the_tables(
    project: Project, content: ReportContent, tmp_path: Path
) -> None:
    write_tables(content, tmp_path / "r.zip")
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        texts = {
            name: archive.read(name).decode("utf-8-sig").splitlines() for name in archive.namelist()
        }
    (histogram,) = (list(csv.reader(v)) for n, v in texts.items() if "histogram-of-v1" in n)
    plane = project.validation[0]
    assert histogram[0] == [
        "From (mm)",
        "To (mm)",
        "Points before calibration",
        "Points after calibration",
    ]
    assert [int(row[3]) for row in histogram[1:]] == plane.counts_after.tolist()
    lows = [float(row[0]) for row in histogram[1:]]
    assert lows == pytest.approx(1000 * plane.bin_edges[:-1], abs=1e-3)
    # The last bin holds all larger distances.
    assert [float(row[1]) for row in histogram[1:-1]] == pytest.approx(lows[1:])
    assert histogram[-1][1] == "and beyond"


def test_invalid_pictures_are_refused(content: ReportContent, tmp_path: Path) -> None:
    broken = tmp_path / "broken.png"
    broken.write_bytes(b"no picture")
    with pytest.raises(LispacError, check=has_code("report.picture_invalid", file=str(broken))):
        write_pdf(content, tmp_path / "r.pdf", {"View": broken}, FULL_REPORT)
    with pytest.raises(InputError, check=lambda e: e.code == "report.picture_unreadable"):
        write_html(content, tmp_path / "r.html", {"View": tmp_path / "gone.png"}, FULL_REPORT)
    with pytest.raises(InputError, check=lambda e: e.code == "report.picture_format"):
        write_html(content, tmp_path / "r.html", {"View": tmp_path / "view.bmp"}, FULL_REPORT)


def test_figures_are_drawn_into_the_given_figure(project: Project) -> None:
    assert project.result is not None
    figure = histogram_figure(project.validation[0])
    (drawn,) = figure.legends
    legend = [text.get_text() for text in drawn.get_texts()]
    assert drawn.get_title().get_text().startswith("V1")
    median = 1000 * project.validation[0].before.median
    assert f"median {median:.1f}" in legend[0]
    again = histogram_figure(project.validation[1], figure)
    assert again is figure
    whole, enlarged = figure.axes
    assert enlarged.get_xlim()[1] < whole.get_xlim()[1] / 2
    (bars,) = figures.residual_figures_of(sighting_values(project.result))
    assert [len(axes.patches) for axes in bars.axes] == 2 * [len(project.result.sightings)]
    values = project.result.estimated, project.result.correlation_all
    assert figures.correlation_figure_of(*values, figure) is figure
    site = figures.site_figure({"L1": [(0, 0), (10, 0)]}, {"T1": (5.0, 2.0, 1.0)}, {}, figure)
    (mark,) = [line for line in site.axes[0].lines if line.get_label() == "target"]
    assert (list(mark.get_xdata()), list(mark.get_ydata())) == ([-2.0], [5.0])  # east, north
    left, right = site.axes[0].get_xlim()
    assert left < right


def test_reciprocal_lines_have_the_colours_of_the_window_side_by_side() -> None:
    there = [(0.0, 0.0), (100.0, 0.0)]
    figure = figures.site_figure({"L1": there, "L2": there[::-1]}, {}, {})
    one, two = figure.axes[0].lines
    colours = [tuple(round(255 * part) for part in line.get_color()) for line in (one, two)]
    assert colours == list(LIGHT_SCHEME.lines[:2])
    places = [line.get_transform().transform((0.0, 50.0)) for line in (one, two)]
    assert np.hypot(*(places[0] - places[1])) * 72 / figure.dpi > 2.0


def test_names_of_near_planes_do_not_overlap_on_the_plan() -> None:
    near = {f"V{k}": (20.0 + 0.6 * k, 30.0 - 0.4 * k, 2.0) for k in range(4)}
    targets = {"T1": (20.5, 30.1, 1.0), "T2": (80.0, -10.0, 1.0)}
    figure = figures.site_figure({"L1": [(0, 0), (100, 0)]}, targets, near)
    figure.set_layout_engine("constrained")
    FigureCanvasAgg(figure).draw()
    labels = [text for text in figure.axes[0].texts if text.get_text() in {*near, *targets}]
    boxes = [Text.get_window_extent(text) for text in labels]
    assert len(boxes) == 6
    assert not [(a, b) for k, a in enumerate(boxes) for b in boxes[k + 1 :] if a.overlaps(b)]
