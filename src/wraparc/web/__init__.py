"""The web calculator: a local server, its API, its pages, and the saved designs."""
