#!/usr/bin/env python3
"""What keeping a campaign's blocks costs on a parallel file system: a simulation, no measurement.

tests/scale/file_system.py [--ranks 1000 10000 100000] [--latency 0.5] [--rate 20000] [--bandwidth 50] [--client 2]
                           [--block 5] [--kilobytes 250] [--scatter 0.3] [--merge 0.12] [--blocks 6]

Every rank computes block after block, of --block seconds on average with a lognormal --scatter, and keeps each. A
metadata server answers --rate operations a second, one after the other, and each takes --latency ms on its way; data go
at --client GB/s from one node and at --bandwidth GB/s in all. Five ways to keep a block:

  files    what overturn does: a file of its own (made, written, synced, renamed, folder synced)
  logs     one file per rank, made once, to which blocks are appended and synced
  nodes    one rank of every 64 appends those of all to one file
  writer   rank 0 appends the rows of all to one file
  shared   parallel HDF5: all ranks write each round of blocks together into one file, and wait for the last

Printed: the share of the ranks' time that is lost, and how long a block waits until it is safe (median and worst)."""

import argparse
import heapq
import random
import statistics

NODE = 64  # ranks


class Server:
    """Takes one request after the other, each for a time."""

    def __init__(self):
        self.free = 0.0

    def take(self, now, seconds):
        self.free = max(self.free, now) + seconds
        return self.free


def block_seconds(options, draw):
    return options.block * draw.lognormvariate(-0.5 * options.scatter**2, options.scatter)


def independent(options, ranks, steps_of):
    """Ranks that wait for nobody: steps_of(rank, first) lists what a block passes, [(server, its seconds, seconds on the
    way)]."""
    draw = random.Random(2013)
    events = []  # (time, rank, blocks begun, step, when the block was ready)
    for rank in range(ranks):
        # Somewhere within a campaign: ranks are not in step.
        events.append((block_seconds(options, draw) * draw.random(), rank, 1, 0, None))
    heapq.heapify(events)
    waits, ends, worked = [], [], 0.0
    steps = {}
    while events:
        now, rank, begun, step, ready = heapq.heappop(events)
        if step == 0:
            ready = now
            steps[rank] = steps_of(rank, begun == 1)
        if step < len(steps[rank]):
            server, seconds, way = steps[rank][step]
            heapq.heappush(events, (server.take(now, seconds) + way, rank, begun, step + 1, ready))
            continue
        waits.append(now - ready)
        if begun == options.blocks:
            ends.append(now)
            continue
        work = block_seconds(options, draw)
        worked += work
        heapq.heappush(events, (now + work, rank, begun + 1, 0, None))
    spent = worked + sum(waits)
    return 1 - worked / spent, waits


def files(options, ranks):
    metadata, data = Server(), Server()
    way, each = options.latency / 1e3, 1 / options.rate
    size = options.kilobytes / 1e6
    steps = [(metadata, each, way), (data, size / options.bandwidth, size / options.client + way), (metadata, each, way),
             (metadata, each, way)]
    return independent(options, ranks, lambda rank, first: steps)


def logs(options, ranks):
    metadata, data = Server(), Server()
    way, size = options.latency / 1e3, options.kilobytes / 1e6
    made = (metadata, 1 / options.rate, way)
    append = (data, size / options.bandwidth, size / options.client + way)
    return independent(options, ranks, lambda rank, first: [made, append] if first else [append])


def gathered(options, ranks, group):
    """One rank of each `group` writes for all of it: its link and its client take one block after the other."""
    writers = [Server() for _ in range((ranks + group - 1) // group)]
    data = Server()
    way, size = options.latency / 1e3, options.kilobytes / 1e6
    # Rows that wait together share a sync: the writer's own time is its copying.
    return independent(options, ranks, lambda rank, first: [(writers[rank // group], size / options.client, way),
                                                            (data, size / options.bandwidth, way)])


def shared(options, ranks):
    draw = random.Random(2013)
    size = options.kilobytes / 1e6
    lost, waits = [], []
    for _ in range(options.blocks):
        works = [block_seconds(options, draw) for _ in range(ranks)]
        write = max(ranks * size / options.bandwidth, size / options.client) + 4 * options.latency / 1e3
        end = max(works) + write
        lost.append(1 - sum(works) / ranks / end)
        waits += [end - work for work in works]
    return statistics.mean(lost), waits


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--ranks", type=int, nargs="+", default=[1000, 10_000, 100_000])
    options.add_argument("--latency", type=float, default=0.5, help="of an operation on its way [ms]")
    options.add_argument("--rate", type=float, default=20_000, help="metadata operations a second")
    options.add_argument("--bandwidth", type=float, default=50, help="of all data servers [GB/s]")
    options.add_argument("--client", type=float, default=2, help="of one node [GB/s]")
    options.add_argument("--block", type=float, default=5, help="a block's work [s]")
    options.add_argument("--kilobytes", type=float, default=250, help="of a block's rows")
    options.add_argument("--scatter", type=float, default=0.3, help="of ln of a block's work")
    options.add_argument("--merge", type=float, default=0.12, help="of one rank, reading, counting and writing [GB/s]")
    options.add_argument("--blocks", type=int, default=6, help="simulated on every rank")
    options = options.parse_args()
    ways = {"files": files, "logs": logs, "nodes": lambda o, n: gathered(o, n, NODE),
            "writer": lambda o, n: gathered(o, n, n), "shared": shared}
    print(f"{'ranks':>7} {'way':7} {'lost':>7} {'median wait':>12} {'worst':>9}    blocks a second, GB/s, merge by one rank")
    for ranks in options.ranks:
        rate = ranks / options.block
        volume = rate * options.kilobytes / 1e6
        merge = options.kilobytes / 1e6 / options.merge * ranks / options.block  # seconds for a second of work
        for name, way in ways.items():
            lost, waits = way(options, ranks)
            print(f"{ranks:7} {name:7} {100 * lost:6.2f} % {statistics.median(waits):10.4f} s {max(waits):7.3f} s"
                  + (f"    {rate:.0f}, {volume:.2f}, {merge:.2f} of the work's time" if name == "files" else ""))


if __name__ == "__main__":
    main()
