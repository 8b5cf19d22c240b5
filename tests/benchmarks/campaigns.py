"""Campaigns that a benchmark runs, and what their plans say: for forecasts.py and two_ranks.py."""

import os
import pathlib
import re

os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})


def program(text):
    return pathlib.Path(text).resolve()


def add_options(parser, seconds, repetitions):
    parser.add_argument("--campaigns", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "campaigns")
    parser.add_argument("--seconds", type=float, default=seconds)
    parser.add_argument("--repetitions", type=int, default=repetitions)
    parser.add_argument("--only", default="")


def chosen(options):
    return [campaign for campaign in sorted(options.campaigns.resolve().glob("*.toml")) if options.only in campaign.stem]


def counts_waves(campaign):
    """Can the number of its waves be stated?"""
    return bool(re.search(r"^count\b", campaign.read_text(), re.MULTILINE))


def one_rank(plan):
    return next(ranks for ranks in plan["ranks"] if ranks["ranks"] == 1)
