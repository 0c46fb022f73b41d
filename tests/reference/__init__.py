"""The API reference: pages from the docstrings, built by Sphinx."""
