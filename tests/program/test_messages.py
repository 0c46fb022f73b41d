"""Tests of messages: texts, translations, codes, levels and storage."""

import ast
import json
import pickle
import re
from pathlib import Path
from string import Formatter
from typing import cast

import numpy as np
import pytest

from lispac.cli.messages import OPTION_HINTS, option_hint
from lispac.duplicate_targets import data_warnings
from lispac.errors import InputError
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.language import (
    LANGUAGES,
    Advised,
    Plural,
    Template,
    format_text,
    gettext,
    in_language,
    without_advice,
)
from lispac.message_texts import ACTIONS, TEXTS, TOPIC_MODULES, message_text
from lispac.message_texts.former_codes import FORMER_CODES, former_code
from lispac.message_texts.occasions import OCCASIONS
from lispac.messages import (
    IMPORTANT_NOTES,
    MAX_LISTED_ITEMS,
    ROUTINE_NOTES,
    Action,
    Level,
    Message,
    error,
    note,
    plain_params,
    shortened_list,
    sort_by_importance,
    warning,
)
from lispac.present.tables import PERCENT
from lispac.value_conversion import decode_value, encode_value
from lispac.warning_causes import Cause
from tests.support.message_calls import calls, is_part, message_levels, trees
from tests.support.report_sample import sample_project

ROOT = Path(__file__).resolve().parents[2]
SAMPLE_VALUES = {
    "": "L1", "n": 3, "names": ("L1", "L2"), "choices": ("L1", "L2"), "sentences": ("L1.", "L2."),
    "title": "Line",
}  # fmt: skip
"""A value for each format specification; quantities get 0.25."""
UNTRANSLATED_TEXTS = [
    TEXTS[code]
    for code in (
        "project.former_text", "axis.latitude", "axis.longitude", "unit.date", "unit.milliradians",
        "unit.radians", "unit.minutes", "format.e57", "format.ply", "format.pcd",
        "format.pof",
    )
]  # fmt: skip
"""Texts that are the same in every language."""


def sample_params(template: Template) -> dict[str, object]:
    """Return values for all placeholders of a text."""
    text = template if isinstance(template, str) else template.plural
    found = {
        name: SAMPLE_VALUES.get(spec or "", 0.25)
        for _, name, spec, _ in Formatter().parse(text)
        if name
    }
    parts = (template.statement, template.advice) if isinstance(template, Advised) else (template,)
    return {"count": 3, **found} if any(isinstance(each, Plural) for each in parts) else found


@pytest.mark.parametrize(
    ("share", "text", "cell"),
    [
        (0.0, "0.00", "0"), (4e-5, "<\u00a00.01", "<\u00a01"), (5.1e-5, "0.01", "<\u00a01"),
        (0.02, "2.00", "2"),
    ],
)  # fmt: skip
def test_a_small_share_is_not_rounded_to_zero(share: float, text: str, cell: str) -> None:
    assert format_text("{share:percent.2} %", {"share": share}) == f"{text} %"
    assert PERCENT.text(share) == cell


def test_values_are_formatted_by_unit_and_language() -> None:
    text = (
        "{name}: {count:n} points, {step:ms} ms, {turn:deg.2+} deg, {share:percent} %, "
        "{lines:names}, {ways:choices}, {time:s.3} s"
    )
    values = {
        "name": "L1", "count": 12_345, "step": 0.01, "turn": 0.0349065850, "share": 0.25,
        "lines": ("L1", "L2", "L3"), "ways": ("a", "b"), "time": 486014.39,
    }  # fmt: skip
    assert format_text(text, values) == (
        "L1: 12,345 points, 10.0 ms, +2.00 deg, 25.0 %, L1, L2 and L3, a or b, 486014.390 s"
    )
    with in_language("fr"):
        assert format_text(text, values) == (
            "L1: 12\u202f345 points, 10,0 ms, +2,00 deg, 25,0 %, L1, L2 et L3, a ou b, 486014,390 s"
        )


@pytest.mark.parametrize(
    ("value", "spec", "shown"),
    [
        (1e300, "s.6", "1.00e+300"), (-1e300, "m+", "-1.00e+300"), (10**400, "n", "1.00e+400"),
        (2.5e-12, "x", "2.50e-12"), (2.5e-12, "x.3", "0.000"), (0.0, "x", "0"),
        (123_456_789_012_345, "n", "123,456,789,012,345"), (float("nan"), "s", "nan"),
        (float("inf"), "s+", "+inf"),
    ],
)  # fmt: skip
def test_formats_of_very_large_and_small_numbers(value: float, spec: str, shown: str) -> None:
    assert format_text(f"{{value:{spec}}}", {"value": value}) == shown


def test_a_count_selects_singular_or_plural() -> None:
    text = Plural("{count:n} point", "{count:n} points")
    shown = [format_text(text, {"count": count}) for count in (0, 1, 2)]
    assert shown == ["0 points", "1 point", "2 points"]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_message_can_be_shown_in_every_language(language: str) -> None:
    with in_language(language):
        for template in (*TEXTS.values(), *ACTIONS.values()):
            text = format_text(template, sample_params(template))
            assert text
            assert not set("{}") & set(text)
            same = text == text_of_english(template)
            assert same == (language == "en" or template in UNTRANSLATED_TEXTS), text


def text_of_english(template: Template) -> str:
    with in_language("en"):
        return format_text(template, sample_params(template))


def sentences(text: str) -> list[str]:
    """Split an English text into sentences; a placeholder for a sentence counts as one."""
    ended = re.sub(r"((?:^|[.!?:] ){\w+(?::sentences)?})(?= [A-Z]| {action})", r"\1.", text)
    return re.split(r"(?<=[.!?])[\")]?\s+(?=[A-Z{\d])", ended)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("Up to 0.5 m (TIME, ..., X). Save as… {name} is kept.", 2),
        ("Not saved: {reason}", 1), ("{file}: {reason} Copy it.", 2),
        ("{x}: no. {reason} {action}", 3), ("{reasons:sentences} See.", 2),
    ],
)  # fmt: skip
def test_sentences_are_counted(text: str, count: int) -> None:
    assert len(sentences(text)) == count


def test_a_text_has_at_most_two_sentences() -> None:
    forms = {
        code: [text] if isinstance(text, str) else [text.singular, text.plural]
        for code, text in TEXTS.items()
    }
    assert [code for code, texts in forms.items() if max(map(len, map(sentences, texts))) > 2] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_report_omits_the_advice_of_notes_only(language: str) -> None:
    code = "adjustment.one_facing"
    reason = note("report.not_compared", reason=error(code))
    with in_language(language):
        template = TEXTS[code]
        assert isinstance(template, Advised)
        statement, advice = (gettext(each) for each in (template.statement, template.advice))
        assert message_text(note(code)) == f"{statement} {advice}"
        with without_advice():
            assert message_text(note(code)) == statement
            assert message_text(warning(code)) == f"{statement} {advice}"
            assert message_text(reason).endswith(statement)
            assert message_text(note(code)) == statement
        assert message_text(reason).endswith(advice)


def test_advice_belongs_to_texts_that_can_be_notes() -> None:
    levels = message_levels()
    advised = [code for code, text in TEXTS.items() if isinstance(text, Advised)]
    assert [code for code in advised if "note" not in levels[code] | made_levels(code)] == []


def made_levels(code: str) -> set[str]:
    """Levels of codes that are made from variables."""
    return {"note"} if made_from_parts(code) else set()


def test_no_code_is_in_two_topics() -> None:
    assert len(TEXTS) == sum(len(topic.TEXTS) for topic in TOPIC_MODULES)


def test_every_topic_has_a_phrase_on_its_occasion() -> None:
    assert set(OCCASIONS) == {code.partition(".")[0] for code in TEXTS}
    assert all(OCCASIONS.values())


def test_messages_are_made_with_the_parameters_of_their_texts() -> None:
    for place, call in calls():
        code = cast(ast.Constant, call.args[0]).value
        assert code in TEXTS, place
        passed = {each.arg for each in call.keywords} - {"subject", "actions"}
        if None not in passed:  # a call with ** is not checked
            assert passed >= set(sample_params(TEXTS[code])), (place, code)


def test_every_code_is_used() -> None:
    used = {
        node.value
        for path, tree in trees().items()
        if path.parent.name != "message_texts"
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    assert [code for code in TEXTS if code not in used and not made_from_parts(code)] == []


def made_from_parts(code: str) -> bool:
    """Whether a code is composed at run time, for example ``recovery.lever_arm_x``."""
    return code.startswith(
        (
            "acceptance_failure.", "acceptance_field.", "acceptance_value.", "amount.", "audit.",
            "change.", "identity_field.", "quantity.", "recovery.", "adjustment.contradicted_",
        )
    )  # fmt: skip


def test_an_error_shows_its_message_in_the_language_in_use() -> None:
    raised = InputError(error("cache.not_writable", folder="/a\nb", used="/c"))
    assert raised.code == "cache.not_writable"
    english = str(raised)
    assert "/a b" in english
    with in_language("fr"):
        assert str(raised) != english
    assert str(pickle.loads(pickle.dumps(raised))) == english


def test_messages_are_stored_in_the_project_file(tmp_path: Path) -> None:
    message = Message(
        "settings.parameter_twice",
        Level.WARNING,
        {"step": 0.01, "count": 3, "lines": ("L1", "L2"), "name": "L1"},
        Cause.of_line("L1"),
        (Action("set_option", {"name": "withheld", "value": "keep"}),),
    )
    assert decode_value(json.loads(json.dumps(encode_value(message))), Message) == message
    project = sample_project(tmp_path / "p").with_data_messages((message,))
    write_project(project)
    assert read_project(project.folder).data_messages == (message,)
    path = project.folder / PROJECT_FILE_NAME  # a project file of an older version has no messages
    content = json.loads(path.read_text())
    del content["data_messages"]
    path.write_text(json.dumps(content))
    assert read_project(project.folder).data_messages == ()


def test_lines_with_the_same_warning_are_named_together(tmp_path: Path) -> None:
    messages = tuple(
        Message(
            "recovery.unexplained", level, {"line": name, "misfit": 0.05}, Cause.of_line(name)
        )
        for name, level in (
            ("L1", Level.WARNING), ("L2", Level.WARNING), ("L3", Level.WARNING), ("L4", Level.NOTE)
        )
    )  # fmt: skip
    (found,) = data_warnings(sample_project(tmp_path / "p").with_data_messages(messages))
    assert (found.code, found.level, found.subject) == (
        "data.same_on_lines", Level.WARNING, Cause.of_line("L1"),
    )  # fmt: skip
    assert found.params == {"reason": messages[0], "lines": ["L2", "L3"], "effect": 0.05}
    assert former_code(found) == "recovery.unexplained"
    assert message_text(found).startswith(message_text(messages[0]))


def test_a_long_list_is_shortened_and_the_rest_counted() -> None:
    names = list("ABCDEFGH")
    assert shortened_list(names[:MAX_LISTED_ITEMS]) == tuple(names[:MAX_LISTED_ITEMS])
    assert shortened_list(names) == (*names[:MAX_LISTED_ITEMS], note("item.more", count=4))
    found = note("adjustment.target_excluded", targets=shortened_list(names))
    assert "A, B, C, D and 4 more." in message_text(found)
    with in_language("fr"):
        assert "A, B, C, D et 4 autres." in message_text(found)


def test_errors_come_before_warnings_and_these_before_notes() -> None:
    one, two = note("report.left_out_target"), note("report.not_validated")
    bad, worse = warning("report.not_calibrated"), error("project.refused", reason="So.")
    assert sort_by_importance([one, bad, two, worse]) == (worse, bad, one, two)
    assert [each.is_serious for each in (one, bad, worse)] == [False, True, True]


def test_important_notes_come_first_and_routine_notes_last() -> None:
    codes = [
        "report.simulated", "adjustment.signs_agree", "report.sightings", "report.left_out_target",
        "validation.offset_not_smaller", "report.left_out_plane", "adjustment.sigmas_raised",
        "report.noise_differs", "acceptance.cause_pos", "acceptance.halves_differ",
    ]  # fmt: skip
    found = sort_by_importance([warning("report.not_calibrated"), *map(note, codes)])
    assert [each.code for each in found] == [
        "report.not_calibrated", "acceptance.cause_pos", "acceptance.halves_differ",
        "validation.offset_not_smaller", "report.noise_differs", "adjustment.sigmas_raised",
        "report.left_out_target", "report.left_out_plane", "report.sightings",
        "adjustment.signs_agree", "report.simulated",
    ]  # fmt: skip


def test_the_codes_that_order_the_notes_exist() -> None:
    for beginning in (*IMPORTANT_NOTES, *ROUTINE_NOTES):
        assert any(code.startswith(beginning) for code in TEXTS), beginning


def test_parameters_are_converted_to_json() -> None:
    angle = note("quantity.roll")
    found = warning(
        "adjustment.large_sigma",
        angles=(note("item.angle_sigma", angle=angle, sigma=0.01), "x"), ratio=float("nan"),
    )  # fmt: skip
    assert json.loads(json.dumps(plain_params(found), allow_nan=False)) == {
        "angles": [
            {
                "code": "item.angle_sigma",
                "params": {"angle": {"code": "quantity.roll", "params": {}}, "sigma": 0.01},
            },
            "x",
        ],
        "ratio": None,
    }


def test_former_codes_belong_to_existing_messages() -> None:
    names = {code.partition(".")[2] for code in TEXTS}
    assert set(FORMER_CODES) <= names
    assert former_code(note("adjustment.contradicted_latency_alone")) == "contradicted_latency"
    assert former_code(note("report.simulated")) == "simulated"
    assert former_code(note("audit.no_range")) == "audit.no_range"


def test_numpy_numbers_are_converted_to_python() -> None:
    made = note(
        "audit.noise_classes", line="L1", count=np.int64(3), classes=[np.int32(7)],
        share=np.float32(0.5),
    )  # fmt: skip
    assert made.params == {"line": "L1", "count": 3, "classes": [7], "share": 0.5}
    assert [type(value) for value in made.params.values()] == [str, int, list, float]
    assert decode_value(json.loads(json.dumps(encode_value(made))), Message).params["count"] == 3


def test_the_level_of_every_code_is_known() -> None:
    """The table of messages in the manual contains it; parts of messages have no level."""
    levels = message_levels()
    assert [code for code in TEXTS if not is_part(code) and not levels[code]] == []
    assert levels["quality.rough"] == {"note"}  # passed as a variable
    assert levels["patch_test.no_roll"] == {"error"}  # from a table
    assert levels["audit.several_scanners"] == {"warning"}  # with a formatted code


COMMAND_LINE_PATTERN = re.compile(r"(?<![\w-])--\w|\blispac \w|`")
"""Matches an option or a command in a text."""
TOPICS_OF_OTHER_PROGRAMS = {"cluster"}
"""Topics whose messages name commands of other programs (dask)."""


@pytest.mark.parametrize("language", LANGUAGES)
def test_texts_name_no_command_line_options(language: str) -> None:
    """The command line adds the options to the messages."""
    with in_language(language):
        naming = {
            code
            for code, template in (TEXTS | ACTIONS).items()
            if COMMAND_LINE_PATTERN.search(format_text(template, sample_params(template)))
        }
    assert [code for code in naming if code.partition(".")[0] not in TOPICS_OF_OTHER_PROGRAMS] == []


def test_the_command_line_adds_options_to_messages() -> None:
    assert OPTION_HINTS.keys() <= TEXTS.keys()
    assert [code for code in OPTION_HINTS if COMMAND_LINE_PATTERN.search(str(TEXTS[code]))] == []
    refused = error("project.refused", reason=error("adjustment.parallel_planes"))
    assert option_hint(refused) == "--accept-single-orientation"
    assert option_hint(note("history.no_date", project="May")) == "lispac identity May --dates"


def test_a_title_in_a_message_is_translated_with_it() -> None:
    wrong = error("window.name_length", field="Name", longest=24)
    assert message_text(wrong).startswith("Name: ")
    with in_language("fr"):
        assert message_text(wrong).startswith("Nom\xa0: ")
