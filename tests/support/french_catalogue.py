"""The French catalogue, as a mapping."""

from babel.messages.pofile import read_po

from lispac.installation_paths import resource_path


def _texts() -> dict[str, str]:
    with (resource_path("i18n") / "fr" / "LC_MESSAGES" / "lispac.po").open("rb") as file:
        messages = [message for message in read_po(file) if message.id]
    found = {}
    for message in messages:
        english = message.id if isinstance(message.id, tuple) else (message.id,)
        french = message.string if isinstance(message.string, tuple) else (message.string,)
        found.update(zip(english, french, strict=True))
    return found


FRENCH = _texts()
"""French text by English text; both forms of plurals."""
