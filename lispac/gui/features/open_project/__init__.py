"""Opening, saving and leaving projects, and step 1."""
