"""Draws a figure or a page as the program asks for it: draw.py SCRIPT DATA.json OUTPUT. The interpreter is an isolated one
(-I), so that no PYTHONPATH, PYTHONHOME or folder of the user's takes the place of what is imported here."""

import importlib
import json
import os
import sys


def main(script, data, output):
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    for setting in ("MPLBACKEND", "MATPLOTLIBRC"):  # of somebody's own sessions
        os.environ.pop(setting, None)
    from overturn import Error
    try:
        drawing = importlib.import_module("overturn.report." + script.removesuffix(".py"))
        from overturn.report import style
        with open(data, encoding="utf-8") as file:
            drawing.draw(style.told(json.load(file)), output)
    except Error as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main(*sys.argv[1:])
