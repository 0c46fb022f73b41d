"""Make the pictures of the manual by following its pages in the program.

``python -m tests.documents.manual_pictures`` goes through the tutorial in both languages and writes
each picture where its page has one. It needs a screen of at least 1600 x 1000, if only a virtual
one, and takes a minute; ``--language fr`` makes those of one language.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QApplication, QWidget

from lispac.language import LANGUAGES
from tests.support.tutorial_steps import page, steps_of

if TYPE_CHECKING:
    from PIL import Image

WIDTH, HEIGHT = 1280, 800
PAGES = ("tutorial",)


def photograph(language: str) -> None:
    """Follow the pages in one language and take their pictures."""
    from lispac.gui.app.settings import AppSettings
    from lispac.gui.project import controller
    from lispac.gui.viewport.vtk_viewport import VtkViewport
    from lispac.gui.window.session import Session
    from tests.gui.reader import Reader, picture_file

    application = QApplication(sys.argv[:1])
    with tempfile.TemporaryDirectory() as scratch:
        demo = Path(scratch) / "demo"
        controller.demo_folder = lambda: demo
        settings = AppSettings(Path(scratch) / "settings.ini")
        settings.language, settings.theme = language, "light"
        session = Session(application, VtkViewport, settings)
        session.window.setGeometry(0, 0, WIDTH, HEIGHT)
        try:
            for name in PAGES:
                source = page(language, name)

                def take(front: QWidget, picture: str, source: Path = source) -> None:
                    session.window.task_bar.clearMessage()  # it names folders
                    application.processEvents()
                    save(front, picture_file(source, picture))

                Reader(session.window, steps_of(source.read_text("utf-8")), take).follow()
        finally:
            session.window.document.undo_stack.setClean()
            session.window.stop_and_hide()


def save(widget: QWidget, file: Path) -> None:
    """Save a picture of a window on the screen, including its 3D view, with few colours."""
    from PIL import Image

    place = widget.frameGeometry()
    shot = widget.screen().grabWindow(0, place.x(), place.y(), place.width(), place.height())
    file.parent.mkdir(parents=True, exist_ok=True)
    shot.save(str(file))
    with Image.open(file) as opened:
        picture = opened.convert("RGB")
    few = picture.quantize(palette=_palette(picture), dither=Image.Dither.NONE)
    few.save(file, optimize=True)
    print(f"{file.parent.parent.name}/{file.name}: {file.stat().st_size / 1e3:.0f} kB", flush=True)


def _palette(picture: "Image.Image") -> "Image.Image":
    """256 colours: most for frequent colours, some for rare ones, such as the swatch of a line."""
    from PIL import Image

    much, rare = Image.Quantize.MEDIANCUT, Image.Quantize.MAXCOVERAGE
    colours = [
        (picture.quantize(number, method).getpalette() or [])[: 3 * number]
        for number, method in ((192, much), (64, rare))
    ]
    palette = Image.new("P", (1, 1))
    palette.putpalette([value for each in colours for value in each])
    return palette


def main() -> None:
    """Take all pictures, each language in a separate process."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.documents.manual_pictures", description=__doc__
    )
    parser.add_argument("--language", choices=list(LANGUAGES), help="this one only, and here")
    language = parser.parse_args().language
    if language is not None:
        photograph(language)
        return
    for each in LANGUAGES:
        command = [sys.executable, "-m", "tests.documents.manual_pictures", "--language", each]
        subprocess.run(command, check=True, env=dict(os.environ))


if __name__ == "__main__":
    main()
