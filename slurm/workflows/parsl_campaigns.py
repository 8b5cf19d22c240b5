"""Campaigns as tasks of Parsl: each is run to its end, and fitted once it is complete.

    python3 slurm/workflows/parsl_campaigns.py CAMPAIGN.toml ... [--launch "mpirun -n 8"]

The Python package overturn must be found (PYTHONPATH=PREFIX/share/overturn/python). The tasks run here, two at a time; on a
cluster put an HighThroughputExecutor with a SlurmProvider in the place of the threads."""

import argparse
import pathlib

import overturn
import parsl
from parsl.app.app import python_app
from parsl.config import Config
from parsl.executors.threads import ThreadPoolExecutor


def cost_of_retry(error, task):
    """A run that was stopped (exit code 3) goes on, as often as it takes; any other failure is the campaign's."""
    return 0.01 if isinstance(error, overturn.Stopped) else 1000


@python_app
def run(campaign, output, launch):
    import overturn
    overturn.run(campaign, output, extend=True, launch=launch).close()
    return output


@python_app
def fit(output):
    import overturn
    return overturn.fit(output)["answer"]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("campaigns", nargs="+")
    arguments.add_argument("--launch", default="")
    asked = arguments.parse_args()
    parsl.load(Config(executors=[ThreadPoolExecutor(max_threads=2)], retries=1, retry_handler=cost_of_retry))
    answers = {name: fit(run(name, pathlib.Path(name).stem + ".h5", asked.launch)) for name in asked.campaigns}
    for name, answer in answers.items():
        for row in answer.result():
            print(name, *(f"{key}={value}" for key, value in row.items() if value is not None))
    parsl.dfk().cleanup()


if __name__ == "__main__":
    main()
