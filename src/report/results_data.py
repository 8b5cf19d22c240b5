"""A results file as plain arrays: what the figures and tables of a report are made of."""

from style import require

require("h5py")

import h5py  # noqa: E402
import numpy as np  # noqa: E402


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class Body:
    """One body: its numbers, its stripes, how the criteria did, and its trials column by column."""

    def __init__(self, file, name, index):
        self.name, self._file, self._index = name, file, index
        self.numbers = {key: float(data[0]) for key, data in file["bodies"][name].items()}
        self.stripes = {key: data[()] for key, data in file["stripes"][name].items()}
        self.criteria = {measure: {key: data[()] for key, data in group.items()}
                         for measure, group in file.get(f"criterion/{name}", {}).items()}
        self.measures = {key: data[()] for key, data in file.get(f"waves/{name}", {}).items()}
        self._mine = np.flatnonzero(file["trials/body"][()] == index)

    def trials(self, column):
        """A column of this body's trials, in the file's order."""
        values = self._file["trials"][column][()]
        return values[self._mine]

    def kinds(self, column):
        """The names of a column's categories, in the order of their values, and which trials are of each."""
        values = self.trials(column)
        names = h5py.check_enum_dtype(self._file["trials"][column].dtype)
        return [(name, values == value) for name, value in sorted(names.items(), key=lambda item: item[1])]

    def verdict(self, name):
        """True where a trial ended so."""
        return dict(self.kinds("verdict"))[name]

    def ended(self, what):
        """True where a trial's end is one that "moved", is "decided" or "fell", as the file says of its verdicts."""
        names = text_of(self._file["trials/verdict"].attrs[what]).split(", ")
        return np.logical_or.reduce([of_it for name, of_it in self.kinds("verdict") if name in names])


class Results:
    def __init__(self, path, names):
        """names: the bodies in the order of the campaign, which numbers them."""
        self.file = h5py.File(path, "r")
        self.about = {key: value if np.isscalar(value) and not isinstance(value, bytes) else text_of(value)
                      for key, value in self.file.attrs.items()}
        self.bodies = [Body(self.file, name, index) for index, name in enumerate(names)]
        self.waves = {key: data[()] for key, data in self.file["waves"].items() if isinstance(data, h5py.Dataset)}

    @property
    def title(self):
        return self.about.get("title") or self.about["campaign_name"]

    @property
    def measured_energy(self):
        """Whether V_WES and ouV_E were wanted."""
        return "v_wes" in self.file["trials"]

    @property
    def measure(self):
        return self.about["level_measure"]

    def in_units(self, amplitude):
        """Amplitudes as people in the field read them, and the unit's name."""
        if self.measure in ("pga", "vector-pga", "sa", "sa-average"):
            return np.asarray(amplitude) * 100, "gal"
        if self.measure == "pgv":
            return np.asarray(amplitude) * 100, "kine"
        if self.measure == "pgd":
            return np.asarray(amplitude) * 100, "cm"
        return np.asarray(amplitude), ""

    def design_basis(self, body):
        """The design-basis amplitude, or None."""
        at = np.flatnonzero(body.stripes["purpose"] == 1)
        return float(body.stripes["amplitude"][at[0]]) if len(at) else None
