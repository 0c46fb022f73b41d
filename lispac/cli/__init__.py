"""The command line: arguments in, workflow calls, numbers out."""
