#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Boots a real-time kernel in QEMU, runs softcnc on its emulated parallel port, and compares every
write that the port sees with the list of edges that the backend stepdir makes of the program.

QEMU emulates the processor too (TCG), so that times mean nothing: order and values are compared.
"""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MODULES = ["drivers/parport/parport.ko", "drivers/parport/parport_pc.ko", "drivers/char/ppdev.ko",
           "drivers/char/lp.ko"]
BASE_NS = 500000  # base_period_us of mill.toml
DATA, CONTROL = 0, 2
ENABLED, REST = 0x00, 0x04  # control register: pin 16 inverted
FLOOD = 0x02  # control register: pin 14, which the port inverts, inverted
SPINDLE = 0x80  # pin 9
BITS = {"x_step": 1, "x_direction": 2, "y_step": 4, "y_direction": 8, "z_step": 16,
        "z_direction": 32}
WRITE = re.compile(r"parallel_ioport_write .*addr (0x[0-9a-f]+) val (0x[0-9a-f]+)")

failures = 0


def check(holds, what):
    global failures
    print(("ok      " if holds else "FAILED  ") + what)
    failures += not holds


def libraries(binary):
    text = subprocess.run(["ldd", binary], capture_output=True, text=True, check=True).stdout
    return [Path(name) for name in re.findall(r"(/\S+) \(0x", text)]


def initramfs(folder, softcnc, kernel):
    """All that the emulated computer has."""
    root = folder / "root"
    (root / "bin").mkdir(parents=True)
    shutil.copy("/bin/busybox", root / "bin/busybox")
    for program in (softcnc, Path("/usr/bin/setpriv")):
        shutil.copy(program, root / program.name)
        for library in libraries(program):
            place = root / library.relative_to("/")
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(library, place)
    for module in MODULES:
        file, = kernel.glob(f"lib/modules/*/kernel/{module}")
        shutil.copy(file, root)
    for name in ("init", "mill.toml", "part.nc"):
        shutil.copy(HERE / name, root)
    (root / "init").chmod(0o755)
    image = folder / "initramfs"
    subprocess.run(f"cd {root} && find . | cpio --quiet -o -H newc | gzip -1 > {image}", shell=True,
                   check=True)
    return image


def boot(folder, image, kernel):
    """Runs init to its end. What it said, and what was written to the port."""
    vmlinuz, = kernel.glob("boot/vmlinuz-*")
    trace = folder / "trace"
    command = ["qemu-system-x86_64", "-accel", "tcg", "-m", "512", "-display", "none", "-nodefaults",
               "-no-reboot", "-serial", "stdio", "-kernel", vmlinuz, "-initrd", image,
               "-append", "console=ttyS0 quiet panic=-1",
               "-chardev", "null,id=port", "-device", "isa-parallel,iobase=0x378,chardev=port",
               "-trace", "parallel_ioport_write", "-D", trace]
    said = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=900, check=False)
    if "== busy" not in said.stdout:
        sys.exit(f"the emulated computer did not get to its end:\n{said.stdout}{said.stderr}")
    writes = [write_of(*numbers) for numbers in WRITE.findall(trace.read_text())]
    return said.stdout.replace("\r", ""), writes


def write_of(address, value):
    """Register and bits. Of the control register only four are pins; Linux sets others."""
    register = int(address, 16) & 7
    return register, int(value, 16) & (0xF if register == CONTROL else 0xFF)


def edges_of(vcd):
    """(time, line, level) of a Value Change Dump."""
    names, time = {}, 0
    for line in vcd.read_text().split("$end\n" "#0\n")[0].splitlines():
        if line.startswith("$var"):
            names[line.split()[3]] = line.split()[4]
    for line in vcd.read_text().split("$dumpvars")[1].split("$end\n", 1)[1].splitlines():
        if line[0] == "#":
            time = int(line[1:])
        else:
            yield time, names[line[1]], line[0] == "1"


def expected_writes(vcd):
    """Each edge with the first base period that is not before it; steps and directions are data.
    Spindle and coolant are on from the first setpoint to the last."""
    by_tick = {}
    for time, name, high in edges_of(vcd):
        by_tick.setdefault(-(-time // BASE_NS), []).append((name, high))
    data = 0
    writes = [(CONTROL, ENABLED), (DATA, data), (CONTROL, ENABLED | FLOOD), (DATA, SPINDLE)]
    for _, edges in sorted(by_tick.items()):
        for name, high in edges:
            data = data | BITS[name] if high else data & ~BITS[name]
        writes.append((DATA, data | SPINDLE))
    return writes + [(CONTROL, ENABLED), (DATA, data), (CONTROL, REST), (DATA, 0)]


def place_of(part, whole, begin=0):
    return next((i for i in range(begin, len(whole) - len(part) + 1)
                 if whole[i:i + len(part)] == part), None)


def ends_at_rest(writes):
    """Drives disabled, all lines low; behind that only what Linux writes when the port is claimed."""
    rest = [(CONTROL, REST), (DATA, 0)]
    ends = [i + 2 for i in range(len(writes) - 1) if writes[i:i + 2] == rest]
    return ends and all(register == CONTROL for register, _ in writes[ends[-1]:])


def check_endings(said):
    endings = {"whole": (0, ""), "estop": (4, "SC5031"), "stopped": (143, ""), "killed": (139, ""),
               "missing": (5, "SC6072"), "wrong": (5, "SC6072"), "denied": (5, "SC6072"),
               "busy": (5, "SC6073")}
    for name, (status, code) in endings.items():
        part = re.search(f"== {name}\n(.*?)== status (\\d+)\n", said, re.DOTALL)
        text = part[1] if part else said
        check(part and int(part[2]) == status and code in text,
              f"{name}: status {part and part[2]} {text.strip()}")


def check_writes(expected, writes):
    print(f"        {len(expected)} writes expected, {len(writes)} seen in all runs")
    first = place_of(expected, writes)
    check(first is not None, "every write of the whole run, in order, and none between")
    if first is None:
        first = place_of(expected[:2], writes) or 0
        wrong = next((i for i, (e, w) in enumerate(zip(expected, writes[first:])) if e != w), None)
        print(f"        the first that differs: {wrong}: {expected[wrong:wrong + 5]}, "
              f"not {writes[first + wrong:first + wrong + 5]}")
        return
    begun = [i for i in range(len(writes) - 1) if writes[i:i + 2] == expected[:2]]
    check(len(begun) == 3, f"three runs enabled the drives: {len(begun)}")
    for name, begin, end in zip(("whole", "stopped", "killed"), begun, begun[1:] + [len(writes)]):
        check(ends_at_rest(writes[begin:end]), f"{name}: the port ends at rest")
    for name, begin, end in zip(("stopped", "killed"), begun[1:], begun[2:] + [len(writes)]):
        count = len([w for w in writes[begin:end] if w[0] == DATA])
        check(10 < count < len(expected), f"{name}: in the midst, behind {count} writes")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--softcnc", required=True, type=Path)
    parser.add_argument("--kernel", required=True, type=Path, help="the unpacked package")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        vcd = folder / "edges.vcd"
        subprocess.run([options.softcnc, "run", "-q", "--machine", HERE / "mill.toml", "--backend",
                        "stepdir", f"--set=backend.stepdir.file={vcd}", HERE / "part.nc"],
                       check=True)
        image = initramfs(folder, options.softcnc, options.kernel)
        said, writes = boot(folder, image, options.kernel)
        check_endings(said)
        check_writes(expected_writes(vcd), writes)
    print(f"{failures} failed")
    return 1 if failures else 0


sys.exit(main())
