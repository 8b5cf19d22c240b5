"""What can go wrong, and what has to be installed."""

import importlib


class Error(Exception):
    """One line: problem (why), and what to do."""


class Failed(Error):
    """The program ended with an error; `code` is its exit code (2: bad input)."""

    def __init__(self, text, code):
        super().__init__(text)
        self.code = code


class Stopped(Failed):
    """A run ended early and can go on: `run(..., resume=True)` (exit code 3)."""


def require(*modules, what="figures are drawn with it"):
    """Imports modules, or raises Error with the packages to install."""
    missing = []
    for name in modules:
        try:
            importlib.import_module(name)
        except ImportError:
            missing.append("python3-" + name)
    if missing:
        names = " ".join(missing)
        raise Error(f"{names} missing ({what}). Install it: apt-get install {names}, or let OVERTURN_PYTHON name a Python that has it")
