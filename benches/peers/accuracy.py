#!/usr/bin/env python3
"""Puts a Verilator model beside `stepwright accuracy`: the same exported netlist, the same sweep, in one run.

    python3 benches/peers/accuracy.py [--max N] [--repeat N]

Builds target/release/stepwright's export of su1522157/measured_interpolator with Verilator -O3, checks that both find the same
greatest deviations (a checksum over all segments, and the worst one), and runs both in turn: segments a second of wall
time. The model is one thread, so two processes share the segments; ours takes two threads. The ratio is stated without and
with the time that Verilator takes to build.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import time

from peers import OURS, WORK, Design, install, run

CIRCUIT = "su1522157/measured_interpolator"
MAIN = r"""
#include "Vmeasured_interpolator.h"
#include "verilated.h"
#include <cstdio>
#include <cstdlib>
// Segments of which major mod 2 is the second argument, up to the first; `greatest` of each, as the meter has it.
int main(int, char** arguments) {
    const unsigned max = strtoul(arguments[1], nullptr, 10), part = strtoul(arguments[2], nullptr, 10);
    VerilatedContext context;
    Vmeasured_interpolator top(&context);
    unsigned long long segments = 0, sum = 0, ticks = 0;
    top.x_is_major_35 = 1;
    auto tick = [&] { top.clk = 1; top.eval(); top.clk = 0; top.eval(); ++ticks; };
    top.clk = 0;
    top.eval();
    for (unsigned major = part; major <= max; major += 2) {
        for (unsigned minor = 0; minor <= major; ++minor) {
            top.major_32 = major;
            top.minor_34 = minor;
            top.start_33 = 1;
            tick();
            top.start_33 = 0;
            top.eval();
            while (top.busy) tick();
            sum += top.greatest;
            ++segments;
        }
    }
    printf("%llu %llu %llu\n", segments, sum, ticks);
}
"""


def build() -> tuple:
    """The model, and the wall time of its making."""
    design = Design.export(CIRCUIT)
    folder = design.folder / "verilator"
    folder.mkdir()
    (folder / "main.cpp").write_text(MAIN)
    command = ["verilator", "--language", "1364-2005", "--cc", "--exe", "--build", "-j", "2", "-O3", "-CFLAGS", "-O3", "-Wno-fatal"]
    command += ["--top-module", design.top, "--Mdir", folder / "obj", "main.cpp", *design.files]
    return folder / "obj" / f"V{design.top}", run(command, cwd=folder)[2]


def model(binary, maximum: int) -> tuple:
    """Segments, sum of their `greatest`, and wall seconds of two processes that share them."""
    start = time.monotonic()
    parts = [subprocess.Popen([binary, str(maximum), str(part)], stdout=subprocess.PIPE, text=True) for part in (0, 1)]
    found = [[int(word) for word in part.communicate()[0].split()] for part in parts]
    return sum(f[0] for f in found), sum(f[1] for f in found), time.monotonic() - start


def check(binary, maximum: int) -> None:
    """Both find the same `greatest` of all segments: ours by a sweep with one row each."""
    stimuli, rows = WORK / "segments.csv", WORK / "segments_out.csv"
    pairs = [f"{x},{y}\n" for x in range(maximum + 1) for y in range(x + 1)]
    stimuli.write_text("major_32,minor_34\n" + "".join(pairs))
    run([OURS, "sweep", CIRCUIT, "-s", "x_is_major_35=1", "--from", stimuli, "--out", rows])
    header, *lines = rows.read_text().splitlines()
    column = header.split(",").index("greatest")
    ours = (len(lines), sum(int(line.split(",")[column]) for line in lines))
    theirs = model(binary, maximum)[:2]
    if ours != theirs:
        sys.exit(f"up to {maximum}: Stepwright has {ours}, the model {theirs}")
    print(f"both have the same sum of `greatest` over the {ours[0]} segments up to {maximum}: {ours[1]}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--max", type=int, default=511)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    install()
    WORK.mkdir(parents=True, exist_ok=True)
    binary, building = build()
    check(binary, 63)
    ours, theirs, segments = [], [], 0
    for _ in range(arguments.repeat):
        out, _, wall = run([OURS, "accuracy", "su1522157/interpolator", "--max", arguments.max, "--threads", 2, "--json"])
        segments = json.loads(out)["segments"]
        ours.append(wall)
        found, _, wall = model(binary, arguments.max)
        if found != segments:
            sys.exit(f"{found} segments of {segments}")
        theirs.append(wall)
    ours, theirs = statistics.median(ours), statistics.median(theirs)
    print(f"{segments} segments up to {arguments.max}, medians of {arguments.repeat}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    print(f"Stepwright  {ours:8.2f} s  {segments / ours:12.0f} segments/s")
    print(f"Verilator   {theirs:8.2f} s  {segments / theirs:12.0f} segments/s, built in {building:.1f} s")
    print(f"ratio {theirs / ours:.0f} without building, {(theirs + building) / ours:.0f} with it")


if __name__ == "__main__":
    main()
