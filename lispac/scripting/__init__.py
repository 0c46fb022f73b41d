"""What ``import lispac`` offers to scripts: the steps of the window as Python."""
