"""Sentences in the scripts that make the report's page: its text comes from the program, they hold labels alone.

Usage: sentences.py FOLDER. Prints each string of more than MOST words (documentation and HTML left out)."""

import ast
import pathlib
import re
import sys

MOST = 6  # words of two letters or more


def documented(node):
    return (isinstance(node, (ast.Module, ast.FunctionDef, ast.ClassDef)) and node.body and isinstance(node.body[0], ast.Expr)
            and isinstance(node.body[0].value, ast.Constant))


def strings(tree):
    documentation = {id(node.body[0].value) for node in ast.walk(tree) if documented(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield node.lineno, " ".join(part.value for part in node.values if isinstance(part, ast.Constant))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in documentation:
            yield node.lineno, node.value


def main(folder):
    paths = sorted(pathlib.Path(folder).glob("*_sections.py")) + [pathlib.Path(folder) / name for name in
                                                                  ("campaign_page.py", "grid_map.py", "page_parts.py")]
    for path in paths:
        for line, text in strings(ast.parse(path.read_text(encoding="utf-8"))):
            if "<" not in text and len(re.findall("[A-Za-z]{2,}", text)) > MOST:
                print(f"{path.name}:{line}: {text}")


main(sys.argv[1])
