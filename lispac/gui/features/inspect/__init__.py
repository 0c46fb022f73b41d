"""Views, sections, measurements and pictures."""
