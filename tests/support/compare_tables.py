"""compare_tables.py FILE.h5 FOLDER: holds what overturn export wrote against what h5py reads, cell by cell.

Numbers of csv are equal to the bit, those of the workbook to the 16 digits that it has. Prints every table with its rows
and cells, ends with 1 and what differs."""

import csv
import math
import re
import sys

import h5py
import openpyxl

LIMIT = "overturning"
file = h5py.File(sys.argv[1], "r")
folder = sys.argv[2]


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def columns_below(group, rows, deep):
    """Every column of numbers as long as the table, by the name that it has below its group."""
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and item.shape == (rows,) and item.dtype.kind in "iufO":
            found[name] = item

    if deep:
        group.visititems(visit)
    else:
        for name, item in group.items():
            visit(name, item)
    return found


def meaning_of(column):
    """What turns a stored value into what a cell holds: a name, or the number."""
    if column.dtype.kind == "O":
        return text_of
    names = h5py.check_enum_dtype(column.dtype)
    if names is not None:
        names = {number: name for name, number in names.items()}
    elif "flag_meanings" in column.attrs:
        names = dict(zip(column.attrs["flag_values"], text_of(column.attrs["flag_meanings"]).split()))
    if names is not None:
        return lambda value: "" if names[value] == "(none)" else names[value]
    if "flag_names" in column.attrs:
        flags = text_of(column.attrs["flag_names"]).split()
        return lambda value: " ".join(name for bit, name in enumerate(flags) if value >> bit & 1)
    return lambda value: "" if value != value else value


def expected(table):
    """For each row its cells by name, from the groups of the file alone."""
    if table in ("trials", "waves"):
        groups = [({}, file[table], len(file[table + ("/verdict" if table == "trials" else "/id")]))]
    else:
        name, axis = {"stripes": ("stripes", "amplitude"), "curves": ("fragility", "measure"), "rare": ("rare", "amplitude")}[table]
        limits = list(file["limits"]) if "limits" in file else []
        groups = []
        for limit in [LIMIT, *(each for each in limits if each != LIMIT)]:
            for body in h5py.check_enum_dtype(file["trials/body"].dtype):
                path = f"{name}/{body}" if limit == LIMIT else f"limits/{limit}/{name}/{body}"
                if path in file:
                    groups.append(({"body": body, "limit": limit}, file[path], len(file[path][axis])))
    rows = {}
    for constants, group, length in groups:
        columns = {name: (meaning_of(column), column[...]) for name, column in columns_below(group, length, table in ("trials", "waves")).items()}
        for row in range(length):
            rows.setdefault(tuple(constants.values()), []).append(
                {**constants, **{name: meaning(values[row]) for name, (meaning, values) in columns.items()}})
    return rows


def same(cell, value, digits):
    if isinstance(value, str):
        return cell == value
    if cell == "":
        return False
    number = float(value)
    return float(cell) == (number if digits is None else float(f"{number:.{digits}g}"))


def check(table, header, rows, digits):
    names = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", title).groups() for title in header]
    wanted = expected(table)
    cells = 0
    for row in rows:
        by_title = dict(zip(names, row))
        key = tuple(by_title[name, None] for name in ("body", "limit")) if table in ("stripes", "curves", "rare") else ()
        value_of = wanted[key].pop(0)
        for name in value_of:
            assert any(name == each for each, _ in names), f"{table}: no column {name}"
        seen = set()
        for (name, unit), cell in by_title.items():
            if name in seen:  # a second one, in the unit of the campaign
                stated(table, name, unit, cell, value_of)
                continue
            seen.add(name)
            if name not in value_of:  # only another body, or limit state, has it
                assert cell == "", f"{table}: {name} is {cell!r}, the file has none"
                continue
            assert same(cell, value_of[name], digits), f"{table}: {name} is {cell!r}, not {value_of[name]!r}"
            cells += 1
    assert not any(wanted.values()), f"{table}: rows are missing"
    print(table, len(rows), "rows", cells, "cells")


PER_SI = {"gal": 100, "cm": 100, "t": 1e-3, "deg": math.degrees(1), "mm": 1000}


def stated(table, name, unit, cell, value_of):
    """Levels of these tests are stated in gal, limits in cm."""
    assert unit in PER_SI, f"{table}: {name} in {unit}"
    applies = table != "curves" or value_of["measure"] == "pga"
    if not applies or value_of[name] == "":
        assert cell == "", f"{table}: {name} in {unit} is {cell!r}"
    else:
        assert math.isclose(float(cell), PER_SI[unit] * float(value_of[name]), rel_tol=1e-11), f"{table}: {name} in {unit}"


def of_csv(table):
    with open(f"{folder}/{table}.csv", encoding="utf-8", newline="") as lines:
        header, *rows = csv.reader(lines)
    return header, rows


def of_book(sheet):
    header, *rows = ([("" if cell is None else cell) for cell in row] for row in sheet.iter_rows(values_only=True))
    return header, [row + [""] * (len(header) - len(row)) for row in rows]


try:
    book = openpyxl.load_workbook(f"{folder}/tables.xlsx")
    tables = ["trials", "waves", "stripes", "curves", *(["rare"] if "rare" in file else [])]
    assert book.sheetnames == [*tables, "columns", "about"], book.sheetnames
    for table in tables:
        check(table, *of_csv(table), None)
        check(table, *of_book(book[table]), 16)
    for table in ("columns", "about"):
        (header, rows), (book_header, book_rows) = of_csv(table), of_book(book[table])
        assert (header, rows) == (book_header, [[str(cell) for cell in row] for row in book_rows]), table
    titled = {(table, re.sub(r" \[.*", "", title)) for table in tables
              for title in of_csv(table)[0]}
    assert titled == {(row[0], row[1]) for row in of_csv("columns")[1]}, "columns does not say what each column is"
except AssertionError as fault:
    print(fault)
    sys.exit(1)
