"""Settings of the user as TOML."""
