"""The command line: parses arguments, calls the workflow and prints the results."""
