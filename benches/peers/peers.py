#!/usr/bin/env python3
"""Puts Verilator, Icarus and Yosys CXXRTL beside Stepwright, on the same exported netlists.

    python3 benches/peers/peers.py [--write] [--repeat N]

Installs the peers with apt-get if they are missing (Debian, as root), builds every variant, checks that all come to
the same checksums, runs all in turn N times (5) and prints medians of CPU time, with the ratios and whether each line of the
bar holds. --write also puts the result into docs/engines.md, between its markers.
"""

import argparse
import datetime
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

ROOT = Path(__file__).resolve().parents[2]
OURS = ROOT / "target/release/stepwright"
WORK = ROOT / "target/peers"
PAGE = ROOT / "docs/engines.md"
MARKERS = ("<!-- numbers: written by benches/peers/peers.py --write -->", "<!-- end of numbers -->")

# Circuits that feed themselves: nothing comes in (inputs stay 0), a checksum goes out.
INTERPOLATOR = "bench/self_feeding_interpolator"
GENERATOR = "bench/self_feeding_function_generator"
LARGEST = "bench/self_feeding_system"

# Ticks of one run, so that it takes about a second.
TICKS = {
    "native": 40_000_000,
    "interpreter": 2_000_000,
    "vcd": 2_000_000,
    "fst": 2_000_000,
    "verilator": 8_000_000,
    "verilator-vcd": 1_000_000,
    "verilator-fst": 500_000,
    "icarus": 100_000,
    "icarus-vcd": 50_000,
    "cxxrtl": 10_000_000,
}


def run(command: list, cwd: Path | None = None) -> tuple[str, float, float]:
    """Runs a command; its standard output, CPU seconds (children included) and seconds of wall time."""
    process = subprocess.Popen([str(c) for c in command], cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    start = os.times().elapsed
    out, err = process.stdout.read(), process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    wall = os.times().elapsed - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{err.decode()}{out.decode()}")
    return out.decode(), usage.ru_utime + usage.ru_stime, wall


@dataclass
class Variant:
    """One way to run a circuit."""

    name: str
    ticks: int
    command: Callable[[int], list]  # from a number of ticks
    load: float = 0.0  # CPU seconds from source text to first tick
    seconds: list = field(default_factory=list)

    def checksum(self, ticks: int) -> int:
        out, _, _ = run(self.command(ticks))
        return checksum_of(out)

    def measure(self) -> int:
        out, cpu, _ = run(self.command(self.ticks))
        self.seconds.append(cpu)
        return checksum_of(out)

    @property
    def rate(self) -> float:
        """Million ticks per second of CPU time."""
        return self.ticks / statistics.median(self.seconds) / 1e6


def checksum_of(out: str) -> int:
    out = out.strip()
    return json.loads(out)["outputs"]["checksum"] if out.startswith("{") else int(out.splitlines()[-1])


def install() -> None:
    tools = {"verilator": "verilator", "iverilog": "iverilog", "yosys": "yosys", "yosys-config": "yosys-dev"}
    tools |= {"g++": "g++", "make": "make"}
    missing = [package for tool, package in tools.items() if not shutil.which(tool)]
    if missing:
        run(["apt-get", "update", "-q"])
        run(["apt-get", "install", "-y", "-q", "--no-install-recommends", *missing])


def ours(circuit: str, engine: str, *more) -> Callable[[int], list]:
    return lambda ticks: [OURS, "run", circuit, "--engine", engine, "--ticks", ticks, "--json", *more]


@dataclass
class Design:
    """An exported circuit."""

    circuit: str
    folder: Path
    top: str
    files: list
    inputs: list

    @staticmethod
    def export(circuit: str) -> "Design":
        folder = WORK / circuit.replace("/", "_")
        shutil.rmtree(folder, ignore_errors=True)
        run([OURS, "export", circuit, "--ticks", 1, "--verilog", folder])
        files = sorted(file for file in folder.glob("*.v") if file.name != "bench.v")
        inputs = re.findall(r"^    reg .*?(\w+);$", (folder / "bench.v").read_text(), re.MULTILINE)
        return Design(circuit, folder, circuit.rsplit("/")[-1], files, [name for name in inputs if name != "clk"])


VERILATOR_MAIN = r"""
#include "V{top}.h"
#include "verilated.h"
#include <cstdio>
#include <cstdlib>
{include}
int main(int, char** arguments) {{
    const unsigned long ticks = strtoul(arguments[1], nullptr, 10);
    VerilatedContext context;
    V{top} top(&context);
    {open}
    top.clk = 0;
    top.eval();
    {dump0}
    for (unsigned long tick = 1; tick < ticks; ++tick) {{
        top.clk = 1;
        top.eval();
        {dump}
        top.clk = 0;
        top.eval();
    }}
    {close}
    printf("%llu\n", (unsigned long long)top.checksum);
}}
"""


def verilator(design: Design, trace: str) -> Variant:
    """Verilator; `trace` is empty, `vcd` or `fst`."""
    name = f"verilator-{trace}" if trace else "verilator"
    folder = design.folder / name
    folder.mkdir()
    traced = {
        "include": f'#include "verilated_{trace}_c.h"',
        "open": f"context.traceEverOn(true); Verilated{trace.capitalize()}C dump; top.trace(&dump, 99); dump.open(arguments[2]);",
        "dump0": "dump.dump((uint64_t)0);",
        "dump": "dump.dump((uint64_t)tick);",
        "close": "dump.close();",
    }
    parts = traced if trace else dict.fromkeys(traced, "")
    (folder / "main.cpp").write_text(VERILATOR_MAIN.format(top=design.top, **parts))
    options = {"": [], "vcd": ["--trace"], "fst": ["--trace-fst"]}[trace]
    build = ["verilator", "--language", "1364-2005", "--cc", "--exe", "--build", "-O3", "-CFLAGS", "-O3", "-Wno-fatal", "--top-module", design.top]
    build += [*options, "--Mdir", folder / "obj", "main.cpp", *design.files]
    _, cpu, _ = run(build, cwd=folder)
    binary, dump = folder / "obj" / f"V{design.top}", folder / f"dump.{trace}"
    return Variant(name, TICKS[name], lambda ticks: [binary, ticks, *([dump] if trace else [])], load=cpu)


ICARUS_BENCH = """
`timescale 1ns / 1ns
module icarus_run;
    reg clk = 1'b0;
    wire [63:0] checksum;
    {top} top (.clk(clk), .checksum(checksum){inputs});
    reg [63:0] left;
    initial begin
        {dump}
        if (!$value$plusargs("ticks=%d", left)) $finish(1);
        #1;
        for (left = left - 1; left != 0; left = left - 1) begin
            clk = 1'b1;
            #1;
            clk = 1'b0;
            #1;
        end
        $display("%0d", checksum);
        $finish(0);
    end
endmodule
"""


def icarus(design: Design, trace: bool) -> Variant:
    name = "icarus-vcd" if trace else "icarus"
    folder = design.folder / name
    folder.mkdir()
    dump = f'$dumpfile("{folder}/dump.vcd"); $dumpvars(0, top);' if trace else ""
    inputs = "".join(f", .{name}(1'b0)" for name in design.inputs)
    (folder / "run.v").write_text(ICARUS_BENCH.format(top=design.top, dump=dump, inputs=inputs))
    image = folder / "run.vvp"
    _, cpu, _ = run(["iverilog", "-g2005", "-s", "icarus_run", "-o", image, *design.files, folder / "run.v"])
    return Variant(name, TICKS[name], lambda ticks: ["vvp", "-n", image, f"+ticks={ticks}"], load=cpu)


CXXRTL_MAIN = r"""
#include "design.cc"
#include <cstdio>
#include <cstdlib>
int main(int, char** arguments) {{
    const unsigned long ticks = strtoul(arguments[1], nullptr, 10);
    cxxrtl_design::p_{top} top;
    top.p_clk.set<bool>(false);
    top.step();
    for (unsigned long tick = 1; tick < ticks; ++tick) {{
        top.p_clk.set<bool>(true);
        top.step();
        top.p_clk.set<bool>(false);
        top.step();
    }}
    printf("%llu\n", (unsigned long long)top.p_checksum.get<uint64_t>());
}}
"""


def cxxrtl(design: Design) -> Variant:
    folder = design.folder / "cxxrtl"
    folder.mkdir()
    mangled = design.top.replace("_", "__")
    (folder / "main.cc").write_text(CXXRTL_MAIN.format(top=mangled))
    files = " ".join(str(file) for file in design.files)
    script = f"read_verilog -defer {files}; hierarchy -check -top {design.top}; write_cxxrtl -O6 -g0 {folder}/design.cc"
    include = Path(run(["yosys-config", "--datdir"])[0].strip()) / "include"
    _, generate, _ = run(["yosys", "-q", "-p", script])
    _, build, _ = run(["g++", "-O3", "-std=c++17", f"-I{include}", "-o", folder / "run", folder / "main.cc"])
    return Variant("cxxrtl", TICKS["cxxrtl"], lambda ticks: [folder / "run", ticks], load=generate + build)


def stepwright(design: Design) -> list:
    """Ours: the engines without a trace, and the native one with every signal traced."""
    dump = lambda kind: ["--" + kind, design.folder / f"dump.{kind}"]
    variants = [Variant(engine, TICKS[engine], ours(design.circuit, engine)) for engine in ["native", "interpreter"]]
    return variants + [Variant(kind, TICKS[kind], ours(design.circuit, "native", *dump(kind))) for kind in ["vcd", "fst"]]


def median_cpu(command: list, repeat: int) -> float:
    return statistics.median(run(command)[1] for _ in range(repeat))


def compare(circuit: str, repeat: int) -> dict:
    """Builds every variant of a circuit, checks them against each other, and measures them in turn."""
    design = Design.export(circuit)
    peers = [verilator(design, ""), verilator(design, "vcd"), verilator(design, "fst")]
    peers += [icarus(design, False), icarus(design, True), cxxrtl(design)]
    variants = stepwright(design) + peers
    agreed = {variant.name: variant.checksum(10_007) for variant in variants}
    if len(set(agreed.values())) != 1:
        sys.exit(f"{circuit}: the checksums differ: {agreed}")
    print(f"{circuit}: all {len(variants)} variants agree on checksum {agreed['native']} after 10007 ticks", flush=True)
    for variant in peers:
        variant.load += median_cpu(variant.command(1), repeat)
    for variant in variants[:4]:
        variant.load = median_cpu(variant.command(1), repeat)
    expected = {}
    for turn in range(repeat):
        for variant in variants:
            found = variant.measure()
            if variant.ticks not in expected:
                expected[variant.ticks] = variants[0].checksum(variant.ticks)
            if found != expected[variant.ticks]:
                sys.exit(f"{circuit}: {variant.name} comes to {found} after {variant.ticks} ticks")
        print(f"{circuit}: turn {turn + 1} of {repeat} done", flush=True)
    return {variant.name: variant for variant in variants}


NAMES = {
    "native": "**Stepwright**, native engine",
    "interpreter": "Stepwright, interpreter",
    "vcd": "Stepwright, native, VCD of every signal",
    "fst": "Stepwright, native, FST of every signal",
    "verilator": "Verilator -O3",
    "verilator-vcd": "Verilator --trace",
    "verilator-fst": "Verilator --trace-fst",
    "icarus": "Icarus",
    "icarus-vcd": "Icarus with $dumpvars",
    "cxxrtl": "Yosys CXXRTL -O6, g++ -O3",
}


def table(circuit: str, variants: dict) -> list:
    base = variants["verilator"].rate
    lines = [f"`{circuit}`:", "", "| variant | Mticks/s | vs Verilator | text to first tick, CPU |", "|---|---|---|---|"]
    for name, variant in variants.items():
        load = f"{variant.load:.1f} s" if variant.load >= 1 else f"{variant.load * 1e3:.0f} ms"
        lines.append(f"| {NAMES[name]} | {variant.rate:.3g} | {variant.rate / base:.3g} | {load} |")
    return [*lines, ""]


def sweep(threads: int, repeat: int) -> float:
    """Million ticks a second of wall time over all lanes of a batch."""
    count, ticks = 65_536, 10_000
    stimuli, rows = WORK / "stimuli.csv", WORK / "rows.csv"
    stimuli.write_text("link\n" + "0\n1\n" * (count // 2))
    command = [OURS, "sweep", INTERPOLATOR, "--from", stimuli, "--ticks", ticks, "--threads", threads, "--out", rows]
    return count * ticks / statistics.median(run(command)[2] for _ in range(repeat)) / 1e6


def ring(k: int) -> Path:
    """A circuit of k interpolators, each with a seed of its own, the checksum of one folded into that of the next."""
    wires = [f"wire [31:0] sum_{i};\n" for i in range(k)]
    machines = [
        f"self_feeding_interpolator #(.SEED({0x12345677 + 7919 * i})) machine_{i} "
        f"(.clk(clk), .link(sum_{(i - 1) % k}[31]), .checksum(sum_{i}));\n"
        for i in range(k)
    ]
    path = WORK / f"ring_{k}.v"
    header = f"module ring_{k} (input wire clk, output wire [31:0] checksum);\n"
    path.write_text(f"{header}{''.join(wires + machines)}assign checksum = sum_{k - 1};\nendmodule\n")
    return path


def growth(repeat: int) -> tuple[list, float, float]:
    """Interpolators by the thousand in one netlist: lines of a table, K = 1000 against K = 1, seconds to the first tick."""
    lines = ["K interpolators in one netlist:", "", "| K | M interpolator-ticks/s | text to first tick, CPU |", "|---|---|---|"]
    rates, load = {}, 0.0
    for k in [1, 10, 100, 1000]:
        command = ours(ring(k), "native")
        load = median_cpu(command(1), repeat)
        ticks = 40_000_000 // k
        rates[k] = k * ticks / (median_cpu(command(ticks), repeat) - load) / 1e6
        lines.append(f"| {k} | {rates[k]:.3g} | {load * 1e3:.0f} ms |")
    return [*lines, ""], rates[1000] / rates[1], load


def bar(variants: dict, one: float, two: float, ratio: float, load: float) -> list:
    rate = {name: variant.rate for name, variant in variants.items()}
    first = variants["native"].load
    rows = [
        ("one long run, no trace, vs Verilator -O3", 4, rate["native"] / rate["verilator"]),
        ("one long run, no trace, vs CXXRTL", 2, rate["native"] / rate["cxxrtl"]),
        ("batch, one core, vs Verilator", 40, one / rate["verilator"]),
        ("batch, two cores vs one", 1.8, two / one),
        ("VCD of every signal, vs Verilator --trace", 1.5, rate["vcd"] / rate["verilator-vcd"]),
        ("FST of every signal, vs Verilator --trace-fst", 1, rate["fst"] / rate["verilator-fst"]),
        ("K = 1000, per interpolator-tick, vs K = 1", 0.5, ratio),
    ]
    lines = ["| bar | at least | measured | |", "|---|---|---|---|"]
    lines += [f"| {what} | {least}x | {value:.2f}x | {verdict(value >= least)} |" for what, least, value in rows]
    limits = [("netlist text to first tick, whole process", 0.010, first), ("K = 1000, text to first tick", 1, load)]
    lines += [f"| {what} | at most {most * 1e3:.0f} ms | {value * 1e3:.1f} ms | {verdict(value <= most)} |" for what, most, value in limits]
    return [*lines, ""]


def verdict(holds: bool) -> str:
    return "holds" if holds else "**missed**"


def machine() -> list:
    cpu = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
    version = lambda command: run(command)[0].splitlines()[0]
    return [
        f"{datetime.date.today()}, {cpu[1] if cpu else platform.machine()}, {os.cpu_count()} cores. "
        f"{version(['verilator', '--version'])}; {version(['iverilog', '-V'])}; {version(['yosys', '-V'])}; "
        f"{version(['g++', '--version'])}; {version(['rustc', '--version'])}.",
        "",
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="put the result into docs/engines.md")
    parser.add_argument("--repeat", type=int, default=5, help="turns of which the median is taken")
    arguments = parser.parse_args()
    install()
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=ROOT, check=True)
    WORK.mkdir(parents=True, exist_ok=True)

    stream = compare(INTERPOLATOR, arguments.repeat)
    generator = compare(GENERATOR, arguments.repeat)
    largest = compare(LARGEST, arguments.repeat)
    one, two = sweep(1, arguments.repeat), sweep(2, arguments.repeat)
    many, ratio, load = growth(arguments.repeat)
    batch = [f"Batch of {INTERPOLATOR}: {one:.3g} Mticks/s on one core, {two:.3g} on two.", ""]
    lines = machine() + table(INTERPOLATOR, stream) + batch + many + bar(stream, one, two, ratio, load)
    lines += table(GENERATOR, generator) + table(LARGEST, largest)
    text = "\n".join(lines)
    print(text)
    if arguments.write:
        page = PAGE.read_text()
        before, rest = page.split(MARKERS[0])
        _, after = rest.split(MARKERS[1])
        PAGE.write_text(f"{before}{MARKERS[0]}\n\n{text}\n{MARKERS[1]}{after}")


if __name__ == "__main__":
    main()
