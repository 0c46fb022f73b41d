"""Widget that VTK draws on, which redraws only after changes."""

from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor


class VtkCanvas(QtInteractor):
    """`QtInteractor` that shows its last frame again if nothing has changed.

    Qt paints a widget whenever a menu above it closes or the overlay changes. `QtInteractor` would
    render the scene each time, which takes 0.2 s with software OpenGL, as on remote desktops.

    Attributes
    ----------
    frames : number of rendered frames
    """

    def __init__(self, parent: QWidget) -> None:
        self._changed = True
        self.frames = 0
        # No multisampling: it has no effect on points and is slow with software OpenGL.
        super().__init__(parent, auto_update=False, multi_samples=0)

    def redraw(self) -> None:
        """Render the scene when Qt next paints; several requests cause one rendering."""
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
        """Render if the scene has changed, and show the frame.

        The base class stores Python wrappers of the OpenGL context and its surface. PySide may
        invalidate these although both still exist; the base class then forgets them, and VTK draws
        nothing. They are therefore fetched again.
        """
        if self._ctx is None and self.isValid():
            self.initializeGL()
        if self._changed:
            self.frames += 1
            super().paintGL()
            is_lost = self._ctx is None  # nothing was drawn
            self._changed = is_lost or not self.ren_win.GetReadyForRendering()
            if is_lost:
                self.update()
            return
        self._in_paint = True  # makes the base class skip the rendering
        try:
            super().paintGL()
        finally:
            self._in_paint = False
