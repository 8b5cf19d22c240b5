"""A campaign as a report sees it, body by body: its numbers and stripes as the program tells them, and of its results
file what it does not tell: trials and waves one by one."""

from .. import results as package

import numpy as np


class Body:
    """One body: its numbers, its stripes of overturning, what waves offer it, and its trials column by column."""

    def __init__(self, file, numbers, stripes, trials, waves):
        self.name, self.numbers, self._trials = numbers["name"], numbers, trials
        self.stripes = {key: np.array([np.nan if row[key] is None else row[key] for row in stripes])
                        for key in ("amplitude", "trials", "at_rest", "probability", "purpose")}
        offered = f"waves/{self.name}"
        self.measures = values_of(file.table(offered, waves)) if offered in file else {}
        body = trials["body"]
        self._mine = np.flatnonzero(body.codes == body.categories.index(self.name))

    def trials(self, column):
        """A column of this body's trials, in the file's order; NaN where the file does not have it."""
        if column not in self._trials:
            return np.full(len(self._mine), np.nan)
        return self._trials[column].values[self._mine]

    def kinds(self, column):
        """The names of a column's categories, in the order of their values, and which trials are of each; none where the
        file does not have it."""
        if column not in self._trials:
            return []
        codes = self._trials[column].codes[self._mine]
        return [(name, codes == code) for code, name in enumerate(self._trials[column].categories)]

    def ended(self, what):
        """True where a trial's end is one that "moved", is "decided" or "fell", as the file says of its verdicts."""
        return self._trials["verdict"].of(what)[self._mine]


def values_of(table):
    return {name: column.values for name, column in table.items()}


class CampaignResults:
    def __init__(self, path, bodies, stripes, unit, shown=None):
        """shown: so many waves, the first of the file, are read with their trials; None: all. bodies, stripes: rows of those tables, of overturning. unit: in which levels were written. The program has held the file against its seal."""
        file = package.Results(path, unverified=True)
        waves, trials = len(file.waves["id"]), len(file.trials["verdict"])
        trials = file.table("trials", rows=None if shown is None else trials * shown // waves)
        self.about, self.waves = file.about, values_of(file.table("waves", rows=shown))
        self.measure, self._unit = stripes[0]["measure"], unit
        self.bodies = [Body(file, body, [row for row in stripes if row["body"] == body["name"]], trials, shown)
                       for body in bodies]
        self.ends = [name.replace("-", "_") for name in trials["verdict"].categories]  # the columns of stripes that count them
        self.measured_energy = "v_wes" in trials  # whether V_WES and ouV_E were wanted

    @property
    def title(self):
        return self.about.get("title") or self.about["campaign_name"]

    def in_units(self, amplitude):
        """Amplitudes in the unit that the levels were written in, and its name; empty: a pure number."""
        symbol = self._unit["symbol"]
        return np.asarray(amplitude) / self._unit["si"], "" if symbol == "1" else symbol

    def design_basis(self, body):
        """The design-basis amplitude, or None."""
        at = np.flatnonzero(body.stripes["purpose"] == "design-basis")
        return float(body.stripes["amplitude"][at[0]]) if len(at) else None
