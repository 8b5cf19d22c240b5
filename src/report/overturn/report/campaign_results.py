"""A results file as a report sees it: body by body, what figures and tables are made of."""

from .. import results as package

import numpy as np


class Body:
    """One body: its numbers, its stripes, how the criteria did, and its trials column by column."""

    def __init__(self, file, name, trials):
        self.name, self._trials = name, trials
        self.numbers = {key: float(column.values[0]) for key, column in file.bodies[name].items() if key != "name"}
        self.stripes = values_of(file.stripes[name])
        judged = f"criterion_by_level/{name}" if "criterion_by_level" in file else f"criterion/{name}"
        self.criteria = {measure: values_of(table) for measure, table in file.by_body(judged).items()} if judged in file else {}
        offered = f"waves/{name}"
        self.measures = values_of(file.table(offered)) if offered in file else {}
        self._mine = np.flatnonzero(trials["body"].names == name)

    def trials(self, column):
        """A column of this body's trials, in the file's order."""
        return self._trials[column].values[self._mine]

    def kinds(self, column):
        """The names of a column's categories, in the order of their values, and which trials are of each."""
        codes = self._trials[column].codes[self._mine]
        return [(name, codes == code) for code, name in enumerate(self._trials[column].categories)]

    def verdict(self, name):
        """True where a trial ended so."""
        return dict(self.kinds("verdict"))[name]

    def ended(self, what):
        """True where a trial's end is one that "moved", is "decided" or "fell", as the file says of its verdicts."""
        return self._trials["verdict"].of(what)[self._mine]


def values_of(table):
    return {name: column.values for name, column in table.items()}


class CampaignResults:
    def __init__(self, path, names):
        """names: the bodies in the campaign's order. The program has held the file against its seal."""
        file = package.Results(path, unverified=True)
        trials = file.trials
        self.about, self.waves = file.about, values_of(file.waves)
        self.amplitude_units = trials["amplitude"].units
        self.bodies = [Body(file, name, trials) for name in names]
        self.ends = [name.replace("-", "_") for name in trials["verdict"].categories]  # the columns of stripes that count them
        self.measured_energy = "v_wes" in trials  # whether V_WES and ouV_E were wanted

    @property
    def title(self):
        return self.about.get("title") or self.about["campaign_name"]

    @property
    def measure(self):
        return self.about["level_measure"].replace("-", "_")  # until 1.0 as the key states it: vector-pga

    def in_units(self, amplitude):
        """Amplitudes as people in the field read them, and the unit's name."""
        unit = {"m/s2": "gal", "m/s": "kine", "m": "cm"}.get(self.amplitude_units, "")
        return np.asarray(amplitude) * (100 if unit else 1), unit

    def design_basis(self, body):
        """The design-basis amplitude, or None."""
        at = np.flatnonzero(body.stripes["purpose"] == 1)
        return float(body.stripes["amplitude"][at[0]]) if len(at) else None
