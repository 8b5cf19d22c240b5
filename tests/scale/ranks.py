#!/usr/bin/env python3
"""How busy many ranks are under overturn's own rule for handing out blocks: a simulation, no measurement.

tests/scale/ranks.py [--ranks 8 100 1000] [--waves 262144] [--wave 0.04] [--scatter 0.3] [--slow 20] [--check | --check-equal]
                     [--block 5 --blocks-each 40]

The campaign has --waves, each of --wave seconds. They are cut into blocks as src/campaign/plan.cpp cuts a campaign none of
whose trials runs on points; blocks scatter lognormally (--scatter). --block and --blocks-each state others, so many for
each rank. One rank is --slow times slower than the others. The other numbers of the rule are read from
src/runner/detail/worker.cpp: the share that a rank takes, how long a rank without blocks waits before it takes one over
from a slow rank, how often a rank looks whether its block was taken over. Rank 0 hands out and computes nothing from so
many ranks on as stands there.

Printed: wall time and the share of it that the ranks work, where all are equal, and with the slow rank, without taking over
and with it. --check: ends with 1 where the slow rank costs more than a tenth of the wall time, or 1000 equal ranks
work less than nine tenths of it; --check-equal: of these, only the latter."""

import argparse
import heapq
import pathlib
import random
import re

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
WORKER = SOURCE / "runner" / "detail" / "worker.cpp"
PLAN = SOURCE / "campaign" / "plan.cpp"
RULE = ("ranks_worth_serving", "shares_each", "least_patience_s", "patience_untried_s", "taken_over_look_s", "step")
CUT = ("blocks_wanted", "many_blocks_wanted", "shortest_of_many", "largest_block")


def constants(source, names):
    text = source.read_text()
    found = {name: re.search(rf"\b{name} = ([\d.']+)", text) for name in names}
    missing = [name for name in names if found[name] is None]
    if missing:
        raise SystemExit(f"ranks: {', '.join(missing)} (not in {source.name}: the rule has changed). Change it here too")
    return {name: float(number[1].replace("'", "")) for name, number in found.items()}


def waves_in_blocks(waves):
    """As waves_per_block() of plan.cpp; the last block may be shorter."""
    cut = {name: int(value) for name, value in constants(PLAN, CUT).items()}
    per_look = min(max(waves // cut["blocks_wanted"], 1), cut["largest_block"])
    of_many = min(max(waves // cut["many_blocks_wanted"], cut["shortest_of_many"]), cut["largest_block"])
    size = min(per_look, of_many)
    return [min(size, waves - first) for first in range(0, waves, size)]


class Run:
    """Ranks, blocks and the moments at which something happens."""

    def __init__(self, rule, ranks, costs, speeds, takes_over):
        self.rule, self.ranks, self.costs, self.speeds, self.takes_over = rule, ranks, costs, speeds, takes_over
        self.given, self.there, self.finished = 0, set(), {}
        self.open = set(range(len(costs)))
        self.shares, self.given_out = [[] for _ in range(ranks)], [0] * ranks
        self.longest, self.looks = [0.0] * ranks, [0] * ranks
        self.events, self.ends = [], 0.0
        first = 1 if ranks > rule["ranks_worth_serving"] else 0
        for rank in range(first, ranks):
            heapq.heappush(self.events, (0.0, rank, "free", -1))

    def at(self, now, rank, what, block=-1):
        heapq.heappush(self.events, (now, rank, what, block))

    def begin(self, now, rank):
        """The next block of the rank's share; where none is left it waits."""
        if not self.shares[rank]:
            size = max(1, int((len(self.costs) - self.given_out[rank]) / (self.rule["shares_each"] * self.ranks)))
            first, self.given = self.given, self.given + size
            self.given_out[rank] = self.given
            self.shares[rank] = list(range(min(first, len(self.costs)), min(self.given, len(self.costs))))
        if self.shares[rank]:
            self.compute(now, rank, self.shares[rank].pop(0), "own")
        elif self.takes_over:
            self.wait(now, rank)

    def compute(self, now, rank, block, what):
        took = self.costs[block] * self.speeds[rank]
        self.at(now + took, rank, what, block)
        if what == "own" and self.takes_over:
            self.at(now + self.rule["taken_over_look_s"], rank, "look", block)

    def wait(self, now, rank):
        longest = self.longest[rank]
        patience = max(self.rule["least_patience_s"], longest) if longest > 0 else self.rule["patience_untried_s"]
        self.at(now + patience, rank, "idle")

    def idle(self, now, rank):
        self.looks[rank] += 1
        missing = sorted(self.open)
        turn = (rank + self.looks[rank] * int(self.rule["step"])) % self.ranks
        if turn < 2 * len(missing):
            place = turn % len(missing) if self.ranks > 2 * len(missing) else len(missing) * rank // self.ranks
            self.compute(now, rank, missing[place], "other's")
        elif len(self.there) < len(self.costs):
            self.wait(now, rank)

    def wall(self):
        broken_off = set()
        while self.events and len(self.there) < len(self.costs):
            now, rank, what, block = heapq.heappop(self.events)
            if what == "free":
                self.begin(now, rank)
            elif what == "idle":
                self.idle(now, rank)
            elif what == "look":
                if self.given >= len(self.costs) and block in self.there:
                    broken_off.add((rank, block))
                    self.shares[rank] = [other for other in self.shares[rank] if other not in self.there]
                    self.begin(now, rank)
                elif block not in self.finished.get(rank, set()):
                    self.at(now + self.rule["taken_over_look_s"], rank, "look", block)
            elif (rank, block) not in broken_off:
                self.there.add(block)
                self.open.discard(block)
                self.longest[rank] = max(self.longest[rank], self.costs[block] * self.speeds[rank])
                self.finished.setdefault(rank, set()).add(block)
                self.ends = now
                self.idle(now, rank) if what == "other's" else self.begin(now, rank)
        return self.ends


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ranks", type=int, nargs="+", default=[8, 100, 1000])
    parser.add_argument("--waves", type=int, default=262144)
    parser.add_argument("--wave", type=float, default=0.04)
    parser.add_argument("--block", type=float)
    parser.add_argument("--blocks-each", type=int, default=40)
    parser.add_argument("--scatter", type=float, default=0.3)
    parser.add_argument("--slow", type=float, default=20)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--check-equal", action="store_true")
    options = parser.parse_args()
    rule, slow_costs, idle = constants(WORKER, RULE), False, False
    print(f"{'ranks':>6} {'blocks':>7}  {'alike':>16}  {'one slow':>16}  {'one slow, taken over':>20}   wall time [s], share that works")
    for ranks in options.ranks:
        draw = random.Random(2013)
        lengths = [options.block] * (ranks * options.blocks_each) if options.block else \
            [options.wave * count for count in waves_in_blocks(options.waves)]
        costs = [length * draw.lognormvariate(-0.5 * options.scatter**2, options.scatter) for length in lengths]
        alike, slow = [1.0] * ranks, [1.0] * (ranks - 1) + [options.slow]
        cells, walls = [], []
        for speeds, takes_over in ((alike, True), (slow, False), (slow, True)):
            walls.append(Run(rule, ranks, costs, speeds, takes_over).wall())
            able = sum(1 / speed for speed in speeds)  # rank 0 counts, whether it computes or not
            cells.append(f"{walls[-1]:8.1f} {100 * sum(costs) / (walls[-1] * able):6.1f} %")
        print(f"{ranks:>6} {len(costs):>7}  {cells[0]:>16}  {cells[1]:>16}  {cells[2]:>20}")
        slow_costs = slow_costs or walls[2] > 1.1 * walls[0] * ranks / (ranks - 1 + 1 / options.slow)
        idle = idle or (ranks >= 1000 and sum(costs) < 0.9 * walls[0] * ranks)
    return 1 if (options.check and (slow_costs or idle)) or (options.check_equal and idle) else 0


if __name__ == "__main__":
    raise SystemExit(main())
