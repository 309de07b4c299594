"""plainspoken: tell a robot in plain words what should get done, and ask it how it is going."""


def __getattr__(name: str) -> str:
    """`__version__`, looked up when it is asked for: importlib.metadata costs 70 ms to import."""
    if name == "__version__":
        from importlib.metadata import version  # noqa: PLC0415 - see above

        return version("plainspoken")
    raise AttributeError(f"module 'plainspoken' has no attribute {name!r}")
