"""Every reader of trajectories and accuracies before made and damaged files, at length."""

from pathlib import Path
from time import monotonic

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lispac.io.formats import format_of
from tests.test_trajectory_bad_input import EVERY, anything, attempt, good


def damaged(content: bytes) -> st.SearchStrategy[bytes]:
    """Sound bytes with pieces taken out, changed or put in."""
    place = st.integers(0, len(content))
    edit = st.tuples(place, st.integers(0, 40), st.binary(max_size=9))

    def apply(edits: list[tuple[int, int, bytes]]) -> bytes:
        changed = bytearray(content)
        for start, length, new in edits:
            changed[start : start + length] = new
        return bytes(changed)

    return st.builds(apply, st.lists(edit, min_size=1, max_size=4))


@pytest.mark.long
@pytest.mark.timeout(600)
@pytest.mark.parametrize("key", EVERY)
def test_many_made_and_damaged_files(tmp_path: Path, key: str) -> None:
    """Each reader for a minute or 100,000 inputs; -s shows how many."""
    sound = good(key, tmp_path / "sound").read_bytes()
    inputs, end = 0, monotonic() + 60

    @settings(
        max_examples=500, deadline=None, database=None, suppress_health_check=list(HealthCheck)
    )
    @given(content=anything | damaged(sound))
    def run(content: bytes) -> None:
        nonlocal inputs
        inputs += 1
        (tmp_path / "any").write_bytes(content)
        attempt(format_of(key), tmp_path / "any")

    while inputs < 100_000 and monotonic() < end:
        run()
    print(f"{key}: {inputs:,} inputs")
    assert inputs >= 500
