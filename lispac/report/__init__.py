"""The report: its numbers (`content`), its words (`document`) and its looks (`html`, `pdf`)."""
