"""A results file, column by column: the one reader of it, for users, figures and pages."""

import hashlib
import os
import re
import warnings
from collections.abc import Mapping

from .digests import faults_of, objects_of
from .errors import Error, require

require("numpy", "h5py", what="results files are read with it")

import h5py  # noqa: E402
import numpy as np  # noqa: E402

OLDEST, NEWEST = 3, 5  # formats that this reader knows
FORMER = {"measure_units": "units", "said": "full_name"}  # names in earlier files, and what they are called since
ROW = "row"  # the axis of tables that name none
# Of the file's bytes; where these are more than a stretch, of the digests of its stretches (src/store/seal.cpp).
SEAL = re.compile(rb"\noverturn-seal sha256 (of the sha256 of every 64 MiB )?([0-9a-f]{64}) of ([0-9]{20}) bytes\n\Z")
LONGEST_SEAL, STRETCH = 256, 64 << 20


def plain(value):
    """An attribute as text or number."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.generic):
        return value.item()
    return value.tolist() if isinstance(value, np.ndarray) else value


def name_since(name):
    """A column's name in files of the newest format."""
    return FORMER.get(name, name)


class Column:
    """One column. `units`, `meaning` and `categories` (names in the order of their numbers, empty of plain numbers) are
    read with it, `values` when they are asked for."""

    def __init__(self, data, rows=None):
        self._data, self._rows = data, rows
        self.name = name_since(data.name.rsplit("/", 1)[1])
        self.attrs = {key: plain(value) for key, value in data.attrs.items()
                      if key not in ("DIMENSION_LIST", "REFERENCE_LIST", "CLASS", "NAME")}
        # A column that another program added may say neither, nor along which axis it lies.
        self.units, self.meaning = self.attrs.get("units", ""), self.attrs.get("description", "")
        named = self._numbers_of_names()
        self.categories = tuple(named)
        self._numbers = np.array(list(named.values()))
        scales = [data.dims[n] for n in range(data.ndim)]
        own = self.name if h5py.h5ds.is_scale(data.id) else ""  # an axis is its own
        self.axes = tuple(scale[0].name.rsplit("/", 1)[1] if len(scale) else own for scale in scales)

    def _numbers_of_names(self):
        stored = h5py.check_enum_dtype(self._data.dtype)
        if stored is None and "flag_meanings" in self.attrs:
            stored = dict(zip(self.attrs["flag_meanings"].split(), np.atleast_1d(self.attrs["flag_values"]).tolist()))
        return dict(sorted((stored or {}).items(), key=lambda item: item[1]))

    def __len__(self):
        return len(self._data) if self._rows is None else min(self._rows, len(self._data))

    def __repr__(self):
        return f"<{self._data.name}: {len(self)} of [{self.units}], {self.meaning}>"

    @property
    def values(self):
        """As stored: numbers, of categories too; texts as str."""
        values = self._data[()] if self._rows is None else self._data[:self._rows]
        return np.char.decode(values, "utf-8") if values.dtype.kind == "S" else values

    @property
    def codes(self):
        """Of categories: each row's place in `categories`."""
        values = self.values
        codes = np.searchsorted(self._numbers, values)
        if len(values) and (codes.max() == len(self._numbers) or not np.array_equal(self._numbers[codes], values)):
            raise Error(f"{self._data.file.filename}: {self._data.name} holds a number without a name (damaged?). "
                        "Ask overturn status what became of the file")
        return codes

    @property
    def names(self):
        """Of categories: each row's name."""
        return np.array(self.categories, dtype=str)[self.codes]

    def of(self, what):
        """True where a verdict is one that "moved", is "decided" or "fell", as the file says of its verdicts."""
        if what not in self.attrs:
            raise Error(f"{self._data.file.filename}: {self._data.name} does not say which verdicts are '{what}' (edited?). "
                        "Restore the file or run the campaign again")
        return np.isin(self.categories, self.attrs[what].split(", "))[self.codes]


class Table(Mapping):
    """Columns by name. `axis` is the one that its rows lie on ("row" if no column names them); the attributes of its group
    are in `attrs`."""

    def __init__(self, group, only=None, rows=None):
        """rows: of each column the first so many; None: all"""
        self.attrs = {key: plain(value) for key, value in group.attrs.items()}
        self._columns = {name_since(name): Column(data, rows) for name, data in group.items()
                         if isinstance(data, h5py.Dataset) and (only is None or name in only)}
        self._share_rows()
        axes = [column.axes[0] for column in self._columns.values() if column.axes and column.axes[0]]
        self.axis = max(axes, key=axes.count) if axes else ""
        lengths = {len(column) for column in self._columns.values() if column.axes == (self.axis,)}
        for column in self._columns.values():
            if column.axes == ("",):  # as long as the others: a row each
                column.axes = (self.axis if len(column) in lengths else column.name,)

    def _share_rows(self):
        """Where every column is its own axis, as long as the others, none names the rows: they are numbered."""
        columns = self._columns.values()
        apart = len(columns) > 1 and all(column.axes == (column.name,) for column in columns)
        if apart and len({len(column) for column in columns}) == 1:
            for column in columns:
                column.axes = (ROW,)

    def __getitem__(self, name):
        return self._columns[name_since(name)]

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    @property
    def rows(self):
        """The columns with a value for each row; those of a further axis (up to format 4 in stripes `rung`) are not among them."""
        return {name: column for name, column in self._columns.items() if column.axes == (self.axis,)}

    def to_pandas(self, columns=None):
        """A DataFrame of all columns or of those named; its attrs hold the group's, and dicts `units` and `meanings`."""
        from .frames import frame_of
        return frame_of(self, columns)

    def to_xarray(self, columns=None):
        """A Dataset of all columns or of those named, over the file's own axes."""
        from .frames import dataset_of
        return dataset_of(self, columns)


class BodyTables(Mapping):
    """A table for each body, by name, in the campaign's order."""

    def __init__(self, group):
        found = [(item.attrs.get("index", 0), name) for name, item in group.items() if isinstance(item, h5py.Group)]
        self._tables = {name: Table(group[name]) for _, name in sorted(found)}

    def __getitem__(self, body):
        return self._tables[body]

    def __iter__(self):
        return iter(self._tables)

    def __len__(self):
        return len(self._tables)

    def to_pandas(self, columns=None):
        """All bodies below each other: a column `body` says whose a row is."""
        from .frames import frame_of_bodies
        return frame_of_bodies(self, columns)

    def to_xarray(self, columns=None):
        """All bodies side by side, over an axis `body` of their names."""
        from .frames import dataset_of_bodies
        return dataset_of_bodies(self, columns)


class Limit:
    """One of the campaign's own limit states."""

    def __init__(self, group):
        self.attrs = {key: plain(value) for key, value in group.attrs.items()}
        self.stripes = BodyTables(group["stripes"])
        self.curves = BodyTables(group["fragility"]) if "fragility" in group else {}


class Results:
    """A results file. `about` holds what it says of itself (the campaign's text, seed, versions)."""

    def __init__(self, path, unverified=False):
        self.path = path
        try:
            if not unverified:
                check_seal(path)
            self.file = h5py.File(path, "r")
            self._check_objects(unverified)
        except FileNotFoundError:
            raise Error(f"{name_of(path)}: not there. Is the run complete? overturn status says so") from None
        except OSError as error:
            raise Error(f"{name_of(path)}: cannot be read ({error}). Is it a results file?") from None
        self.about = {key: plain(value) for key, value in self.file.attrs.items()}
        self._check_format()

    def _check_objects(self, unverified):
        try:
            objects = objects_of(self.file)
            faults = "" if unverified else faults_of(self.file, objects)
        except Error as error:
            self.file.close()
            raise Error(f"{name_of(self.path)}: {error}") from None
        if faults:
            self.file.close()
            raise Error(f"{name_of(self.path)}: not as it was written ({faults}). Restore it or run the campaign again; "
                        "overturn.open(..., unverified=True) reads it as it is")

    def _check_format(self):
        version = self.about.get("format_version", 0)
        if self.about.get("format") != "overturn-results":
            raise Error(f"{name_of(self.path)}: no results file of overturn. Name one that `overturn run` wrote")
        if not OLDEST <= version <= NEWEST:
            raise Error(f"{name_of(self.path)}: of format {version} (this package reads {OLDEST} to {NEWEST}). "
                        f"Take the package of the program that wrote it, {self.about.get('program_version', 'unknown')}")
        if version < NEWEST:
            warnings.warn(f"{name_of(self.path)}: of format {version}; `overturn status` says what is known to be wrong in it",
                          stacklevel=4)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.file.close()

    def __repr__(self):
        return f"<{name_of(self.path)}: {self.about.get('title') or self.about['campaign_name']}, {len(self.trials['verdict'])} trials>"

    def __contains__(self, place):
        return place in self.file

    def table(self, place, rows=None):
        """rows: of each column the first so many. The columns of any group: "trials/contact", "quantiles/type-b/peak_slip"; `overturn list columns FILE.h5` names all."""
        self._require(place)
        self._require_columns(place)
        return Table(self.file[place], rows=rows)

    def by_body(self, place):
        """The same of a group that holds one for each body: "isotonic", "grid"."""
        self._require(place)
        bodies = [name for name, item in self.file[place].items() if isinstance(item, h5py.Group)]
        if not bodies:
            raise Error(f"{name_of(self.path)}: {place} holds no groups, but columns. Ask for table(\"{place}\")")
        for body in bodies:
            self._require_columns(f"{place}/{body}")
        return BodyTables(self.file[place])

    def _require(self, place):
        if place not in self.file or not isinstance(self.file[place], h5py.Group):
            raise Error(f"{name_of(self.path)}: holds no {place} (not asked for, or not of its format). "
                        "`overturn list columns` says what it holds")

    def _require_columns(self, place):
        """Some groups hold only further groups, as one for each response."""
        below = tables_below(self.file[place])
        if below and place not in below:
            raise Error(f"{name_of(self.path)}: {place} holds no columns itself, but groups of them. Ask for table() of one: "
                        f"{', '.join(below)}")

    @property
    def bodies(self):
        """What each body is: mass, radius, alpha, V_Ereq ... One row each."""
        return self.by_body("bodies")

    @property
    def levels(self):
        """Amplitude and purpose of each level; a level's number is its row."""
        stripes = self.file["stripes"]
        return Table(stripes[next(iter(self.stripes))], only=("amplitude", "purpose"))

    @property
    def trials(self):
        """A row per trial; a model's own quantities: table("trials/contact")."""
        return self.table("trials")

    @property
    def waves(self):
        """A row per wave; what it offers to each body: by_body("waves")."""
        return self.table("waves")

    @property
    def stripes(self):
        """Counts and exact intervals at each level, by body."""
        return self.by_body("stripes")

    @property
    def curves(self):
        """Fragility curves over each measure of intensity, by body."""
        return self.by_body("fragility")

    @property
    def limits(self):
        """The campaign's own limit states by name: each with `stripes` and `curves`."""
        return {name: Limit(group) for name, group in self.file.get("limits", {}).items()}


def tables_below(group):
    """Where columns lie, in this group and in those below it."""
    found = {}
    group.visititems(lambda _, item: found.setdefault(item.parent.name[1:]) if isinstance(item, h5py.Dataset) else None)
    return list(found)


def name_of(path):
    """A path in a message, whatever bytes it is of."""
    return str(path).encode(errors="surrogateescape").decode(errors="replace")


def _digest_of(file, length):
    digest = hashlib.sha256()
    while length > 0 and (part := file.read(min(length, 1 << 20))):
        digest.update(part)
        length -= len(part)
    return digest.hexdigest()


def _digest_of_stretches(file, length):
    digests = (_digest_of(file, min(STRETCH, length - at)) for at in range(0, length, STRETCH))
    return hashlib.sha256("".join(digests).encode()).hexdigest()


def check_seal(path):
    """Raises Error unless every byte is as the program wrote it."""
    if os.path.exists(path) and not os.path.isfile(path):
        raise Error(f"{name_of(path)}: no results file (nor any file: a folder, pipe or device). Name one that "
                    "`overturn run` wrote")
    with open(path, "rb") as file:
        size = file.seek(0, 2)
        file.seek(max(0, size - LONGEST_SEAL))
        seal = SEAL.search(file.read())
        if seal is None:
            file.seek(0)
            if not file.read(8) == b"\x89HDF\r\n\x1a\n":
                raise Error(f"{name_of(path)}: no results file of overturn. Name one that `overturn run` wrote")
            raise Error(f"{name_of(path)}: never sealed, or edited (written to by another program?). "
                        "overturn.open(..., unverified=True) reads it as it is")
        stretched, told, length = seal[1], seal[2].decode(), int(seal[3])
        file.seek(0)
        digest = _digest_of_stretches(file, length) if stretched else _digest_of(file, length)
    if digest != told or length + len(seal[0]) != size:
        raise Error(f"{name_of(path)}: not as it was written (edited or damaged). `overturn status` names what changed; "
                    "overturn.open(..., unverified=True) reads it as it is")
