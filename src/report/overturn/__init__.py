"""Results of the program overturn as pandas and xarray objects, and the program itself, from Python.

    import overturn

    results = overturn.open("FILE.h5")
    results.trials.to_pandas()                      # a row per trial: names for numbers, NaN for what never came
    results.trials["peak_rotation"].values          # one column, read now: a numpy array
    results.trials["peak_rotation"].units           # "rad"
    results.stripes.to_xarray()                     # over body and amplitude, units in every variable's attrs
    results.curves["type-b"].to_pandas()            # of one body
    results = overturn.run("CAMPAIGN.toml", launch="mpirun -n 4")

Needs numpy and h5py; pandas and xarray where they are asked for. Nothing is read before it is asked for."""

from .errors import Error, Failed, Stopped

__all__ = ["Error", "Failed", "Stopped", "fit", "open", "run", "status"]


def open(path, unverified=False):  # its name in this package: overturn.open
    """A results file, as overturn.results.Results.

    unverified: read it even where its seal says that it is not as it was written.
    Raises Error."""
    from .results import Results
    return Results(path, unverified)


def run(campaign, output=None, **options):
    """Runs a campaign, as overturn.program.run, and opens its results."""
    from . import program
    return program.run(campaign, output, **options)


def status(file, **options):
    """Whether a results file is complete, as overturn.program.status."""
    from . import program
    return program.status(file, **options)


def fit(file, *arguments, **options):
    """The curves of a results file as `overturn fit --json` gives them, as overturn.program.fit."""
    from . import program
    return program.fit(file, *arguments, **options)
