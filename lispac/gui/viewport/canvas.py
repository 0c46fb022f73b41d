"""Widget that VTK draws on, which redraws only after changes."""

from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor


class VtkCanvas(QtInteractor):
    """`QtInteractor` that shows its last frame again if nothing has changed.

    Qt paints a widget whenever a menu over it closes or the text over it changes, and the library
    renders the scene each time: 0.2 s with software OpenGL, which remote desktops have.

    Attributes
    ----------
    frames : how many were rendered
    """

    def __init__(self, parent: QWidget) -> None:
        self._changed = True
        self.frames = 0
        # No multisampling: it has no effect on single pixels and costs software OpenGL dearly.
        super().__init__(parent, auto_update=False, multi_samples=0)

    def redraw(self) -> None:
        """Render the scene when Qt next paints; requests are joined."""
        self._changed = True
        self.update()

    def initializeGL(self) -> None:
        """Initialise a new OpenGL context, also after the window was rebuilt."""
        super().initializeGL()
        self._changed = True

    def resizeGL(self, width: int, height: int) -> None:
        """Redraw in the new size, in pixels of the window."""
        super().resizeGL(width, height)
        self._changed = True

    def paintGL(self) -> None:
        """Render if the scene has changed, and show the frame."""
        if self._changed:
            self.frames += 1
            super().paintGL()
            self._changed = not self.ren_win.GetReadyForRendering()
            return
        self._in_paint = True  # the base class takes it that the frame is being rendered already
        try:
            super().paintGL()
        finally:
            self._in_paint = False
