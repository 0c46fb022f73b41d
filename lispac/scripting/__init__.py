"""Interface of ``import lispac`` for scripts: the steps of the window as Python."""
