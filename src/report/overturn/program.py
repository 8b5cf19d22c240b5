"""The program overturn, called from Python: what it prints parsed, its errors raised."""

import collections
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess

from .errors import Error, Failed, Stopped

HERE = pathlib.Path(__file__).absolute().parent  # not resolved: a build tree holds this package by a link
STOPPED = 3  # exit code of what can go on

Status = collections.namedtuple("Status", "complete text facts")
Status.__doc__ = """Whether a results file is complete (else the run can go on), what `overturn status` says of it in one line,
and all of it as a dictionary: blocks, waves, trials, whether a run is under way, how to go on, an extension."""


def program_path(stated=None):
    """The program: the one stated, $OVERTURN, the one installed or built with this package, that of PATH."""
    if stated or os.environ.get("OVERTURN"):
        return os.fspath(stated or os.environ["OVERTURN"])
    beside = [HERE.parents[3] / "bin" / "overturn",  # PREFIX/share/overturn/python/overturn
              HERE.parents[1] / "overturn"]          # BUILD/src/python/overturn
    source = HERE.parents[2] / ".build" / "release" / "src" / "overturn"
    for path in [*beside, source]:
        if path.is_file() and os.access(path, os.X_OK):
            return str(path)
    found = shutil.which("overturn")
    if found is None:
        raise Error("no program overturn (neither beside this package nor in PATH). Name it: program=..., or in OVERTURN")
    return found


def call(*arguments, program=None, launch=()):
    """Runs the program. \\return what it ended as: returncode, stdout, stderr. Raises Failed where it ended with an error."""
    launch = shlex.split(launch) if isinstance(launch, str) else list(launch)
    command = [*launch, program_path(program), *map(os.fspath, arguments)]
    try:
        ended = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise Error(f"{command[0]}: cannot be run ({error.strerror}). Name the program: program=..., or in OVERTURN") from None
    if ended.returncode == 0 or (ended.returncode == STOPPED and "status" in arguments[:1]):
        return ended
    notes = re.sub(r"\n {4,}", " ", ended.stderr)  # longer notes are wrapped
    lines = [line for line in notes.splitlines() if line.strip()]
    stopped = ended.returncode == STOPPED
    told = [line for line in lines if line.startswith("stopped early: ")] if stopped else []  # other notes come after it
    told += [line for line in lines if line.startswith("overturn: ")]  # and, under mpirun, lines of its own
    told += [line for line in lines if "error: " in line] + lines[-1:] + [f"ended with {ended.returncode}"]
    raise (Stopped if stopped else Failed)(told[0], ended.returncode)


def run(campaign, output=None, *, settings=None, resume=False, extend=False, max_walltime=None, launch=(), program=None):
    """Runs a campaign and opens its results; returns when it is complete.

    output: the results file; default: the campaign's name with .h5, in the working folder
    resume: go on with what an earlier run left; extend: take the rows of a finished file at output
    settings: {"waves.count": 3}: values in place of the file's; text as a campaign file spells it
    launch: "mpirun -n 4", or a list
    Raises Stopped where it ended early and can go on (resume=True), Failed where it cannot, with the program's own words."""
    from .results import Results
    output = os.fspath(output) if output is not None else pathlib.Path(campaign).stem + ".h5"
    arguments = ["run", campaign, "-o", output, *(["--resume"] if resume else []), *(["--extend"] if extend else [])]
    for key, value in (settings or {}).items():
        arguments += ["--set", f"{key}={toml(value)}"]
    if max_walltime is not None:
        arguments += ["--max-walltime", str(max_walltime)]
    call(*arguments, program=program, launch=launch)
    return Results(output)


def toml(value):
    """A value as --set takes it: text as it stands, anything else as TOML spells it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else json.dumps(value)


def status(file, program=None):
    """Whether a results file, or the run that is to write it, is complete: a Status. Cheap, also while it is under way.

    Raises Failed for what is neither."""
    ended = call("status", file, "--json", program=program)
    facts = json.loads(ended.stdout)
    return Status(ended.returncode == 0, facts["text"], facts)


def fit(file, *arguments, interim=False, program=None):
    """What `overturn fit FILE --json` says, parsed: stripes, curves, intervals. arguments: "--beta-u", "0.2" ...

    interim: of the waves that an unfinished run has done so far; "interim" of the answer says how many."""
    flags = ["--interim"] if interim else []
    return json.loads(call("fit", file, "--json", *flags, *arguments, program=program).stdout)
