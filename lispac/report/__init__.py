"""The report: numbers (`content`), texts (`document`) and layout (`html`, `pdf`)."""
