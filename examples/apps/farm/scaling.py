#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Simulates shd-farm on up to 1,000 ranks from measured times of windows. docs/farm.md has the assumptions.

    scaling.py TIMES.csv [--scale S] [--frames N] [--ranks 1,2,...] [assumptions...]

TIMES.csv comes from `shd-farm --times`. A discrete-event simulation: each rank has up to two windows, rank 0 serves
messages one by one, tiles go to a file system of limited bandwidth (or through the link of rank 0), two tiles of a rank
may wait for the disk.
"""
import argparse
import csv
import heapq
import random

RANKS = [1, 2, 4, 16, 64, 128, 256, 512, 1000]


def read_times(path):
    with open(path, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise SystemExit(f"{path}: no windows")
    return [float(row["render_seconds"]) for row in rows]


def frame_times(times, windows, generator):
    """Times of the windows of a frame. Neighbours stay beside each other: fewer measured windows are stretched.
    Each time is changed by up to a fifth so that frames differ."""
    return [times[i * len(times) // windows] * generator.uniform(0.8, 1.2) for i in range(windows)]


class Pipe:
    """A resource that serves one request after the other."""

    def __init__(self):
        self.free = self.busy = 0.0

    def serve(self, now, seconds):
        self.free = max(self.free, now) + seconds
        self.busy += seconds
        return self.free


class Job:
    """The state of a simulated job."""

    def __init__(self, ranks, work, o):
        self.work, self.o, self.ranks, self.next = work, o, ranks, 0
        self.server, self.disk = Pipe(), Pipe()
        self.links = [Pipe() for _ in range(-(-ranks // o.ranks_per_node))]
        self.end = self.rendering = 0.0
        self.held = [0] * ranks               # windows that were handed out and are not rendered
        self.free = [0.0] * ranks             # when the renderer of a rank is free
        self.waiting = [[] for _ in range(ranks)]  # ends of writes of a rank
        self.events = []                      # (time, order, rank), a window is rendered

    def hand_out(self, now, rank):
        """As in serve.cpp: a second window only while enough of them are left."""
        while self.next < len(self.work) and (
                self.held[rank] == 0 or self.held[rank] == 1 and len(self.work) - self.next > 2 * self.ranks):
            seconds = self.work[self.next]
            self.next += 1
            self.held[rank] += 1
            arrival = self.server.serve(now, self.o.service) + self.o.latency + self.o.poll / 2
            begin = max(arrival, self.free[rank])
            while len(self.waiting[rank]) >= 2:  # the writer of the rank is two tiles late
                begin = max(begin, self.waiting[rank].pop(0) - seconds)
            self.free[rank] = begin + seconds
            self.rendering += seconds
            heapq.heappush(self.events, (self.free[rank], self.next, rank))

    def write(self, now, rank):
        tile = self.o.tile_bytes
        link = self.links[rank // self.o.ranks_per_node].serve(now, tile / self.o.link)
        if self.o.through_root:
            link = self.server.serve(link, tile / self.o.link + tile / self.o.root_disk)
            done = link
        else:
            done = self.disk.serve(link, tile / self.o.disk) + self.o.sync
        self.waiting[rank].append(done)
        self.end = max(self.end, self.server.serve(done + self.o.latency, self.o.service))

    def run(self):
        for rank in range(self.ranks):
            self.hand_out(0.0, rank)
        while self.events:
            now, _, rank = heapq.heappop(self.events)
            self.held[rank] -= 1
            self.write(now, rank)
            told = self.server.serve(now + self.o.latency, self.o.service)
            self.hand_out(told, rank)
        return self.end


def limit_of(job):
    """The busiest part of a job, by its share of the time."""
    parts = {"file system": job.disk.busy, "rank 0": job.server.busy, "link of a node": max(p.busy for p in job.links),
             "rendering": job.rendering / job.ranks}
    name = max(parts, key=parts.get)
    return f"{name} {100 * parts[name] / job.end:.0f} %"


def simulate(o, times):
    windows = (o.size // o.window) ** 2
    generator = random.Random(1)
    work = []
    for _ in range(o.frames):
        work += [t * o.scale for t in frame_times(times, windows, generator)]
    way = ", through rank 0" if o.through_root else ""
    print(f"{o.frames} frames of {o.size} x {o.size}, {windows} windows each, {sum(work) / o.frames:.1f} s of rendering "
          f"and {windows * o.tile_bytes / 2**30:.1f} GiB a frame{way}")
    print(" ranks   seconds   speed-up  efficiency  busiest part")
    efficiencies = {}
    for ranks in o.ranks:
        job = Job(ranks, work, o)
        end = job.run()
        efficiencies[ranks] = sum(work) / end / ranks
        print(f"{ranks:6d} {end:9.2f} {sum(work) / end:10.1f} {efficiencies[ranks]:11.3f}  {limit_of(job)}")
    return efficiencies


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("times", help="CSV of shd-farm --times")
    add("--size", type=int, default=16384, help="pixels of a side")
    add("--window", type=int, default=256, help="pixels of a side of a window")
    add("--scale", type=float, default=1.0, help="factor of the measured times")
    add("--frames", type=int, default=8, help="frames of the sequence")
    add("--ranks", default=",".join(map(str, RANKS)), help="numbers of ranks")
    add("--ranks-per-node", type=int, default=32, help="ranks that share a link")
    add("--latency", type=float, default=5e-6, help="of a message [s]")
    add("--service", type=float, default=5e-6, help="time of rank 0 for a message [s]")
    add("--poll", type=float, default=3e-4, help="period at which ranks look for messages [s]")
    add("--link", type=float, default=12.5e9, help="bandwidth of a node [B/s]")
    add("--disk", type=float, default=20e9, help="bandwidth of the shared file system [B/s]")
    add("--root-disk", type=float, default=2e9, help="bandwidth of the disk of rank 0 [B/s]")
    add("--sync", type=float, default=2e-3, help="time until a tile is durable [s]")
    add("--through-root", action="store_true", help="tiles travel to rank 0")
    add("--require", type=float, help="exit 1 unless the efficiency at 256 ranks is at least this")
    o = parser.parse_args()
    o.ranks = [int(n) for n in o.ranks.split(",")]
    if min(o.ranks) < 1 or o.frames < 1 or o.scale <= 0 or not 16 <= o.window <= o.size:
        parser.error("ranks and frames are at least 1, the scale is above 0, the window is in 16..size")
    o.tile_bytes = 20 + 8 * o.window ** 2
    return o


def main():
    o = arguments()
    efficiencies = simulate(o, read_times(o.times))
    if o.require and efficiencies.get(256, 0) < o.require:
        raise SystemExit(f"the efficiency at 256 ranks is below {o.require}")


if __name__ == "__main__":
    main()
