#!/usr/bin/env python3
"""Builds the library for every target for which this machine has a compiler, and compares the results of the targets.

usage: check_targets.py [--only NAME]... [--no-command] [--ticks N]

Builds the library, the program tests/determinism, the game examples/lockstep_rts and, where possible, the command. Runs them
where an emulator is installed. Compares their output, byte for byte, with the output of the native g++ build: 200 worlds
that change, with the paths through them; a game with rollback; and world scripts. Prints a line for each step, then a table.
Leaves the builds in build/targets/. Exits 1 if a build fails or bytes differ. Skips targets without a compiler, and
comparisons without an emulator.
  --only NAME   build this target (and the native one); can be repeated
  --no-command  leave out the command
  --ticks N     run the game for N ticks (120); its acceptance test uses 600
WAYWRIGHT_JOBS limits how many compilers run at once.
"""

import argparse
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build" / "targets"
# The time limit for one program. An emulator takes about a minute.
SECONDS = 3600


@dataclass
class Target:
    name: str
    about: str
    compiler: str
    toolchain: str = ""
    runners: list = field(default_factory=list)  # the first that exists runs the programs; [] means natively
    ending: str = ""  # of a program's file name
    options: list = field(default_factory=list)


def qemu(processor, triplet):
    return [f"qemu-{processor}", "-L", f"/usr/{triplet}"]


NATIVE = Target("native", "this machine, g++", "g++", runners=[[]], options=["-DCMAKE_CXX_COMPILER=g++"])
TARGETS = [
    NATIVE,
    Target("clang", "this machine, clang 14", "clang++-14", runners=[[]], options=["-DCMAKE_CXX_COMPILER=clang++-14"]),
    Target("clang_libcxx", "this machine, clang 14, libc++ 14", "clang++-14", "clang_libcxx", runners=[[]]),
    Target(
        "i686",
        "Linux, 32-bit x86 with SSE2",
        "i686-linux-gnu-g++",
        "i686",
        runners=[
            ["/usr/i686-linux-gnu/lib/ld-linux.so.2", "--library-path", "/usr/i686-linux-gnu/lib"],
            qemu("i386", "i686-linux-gnu"),
        ],
    ),
    Target(
        "aarch64", "Linux, 64-bit ARM", "aarch64-linux-gnu-g++", "aarch64", runners=[qemu("aarch64", "aarch64-linux-gnu")]
    ),
    Target(
        "riscv64", "Linux, 64-bit RISC-V", "riscv64-linux-gnu-g++", "riscv64", runners=[qemu("riscv64", "riscv64-linux-gnu")]
    ),
    Target(
        "s390x", "Linux, IBM Z (big endian)", "s390x-linux-gnu-g++", "s390x", runners=[qemu("s390x", "s390x-linux-gnu")]
    ),
    Target(
        "mingw64", "Windows, 64-bit x86", "x86_64-w64-mingw32-g++-posix", "mingw64", runners=[["wine"]], ending=".exe"
    ),
    # Emscripten in Debian 12 is older than Node's function `fetch`, and would use that function for files.
    Target("wasm", "WebAssembly (32 bits)", "em++", "wasm", runners=[["node", "--no-experimental-fetch"]], ending=".js"),
]

# The only folders of this machine's headers that cross compilers may use. The rest of /usr/include describes another
# machine.
HEADERS = ["boost", "fast_float", "CLI", "fmt", "nlohmann"]
PACKAGES = {
    "CLI11": ("CLI11::CLI11", ""),
    "fmt": ("fmt::fmt", "FMT_HEADER_ONLY=1"),
    "nlohmann_json": ("nlohmann_json::nlohmann_json", ""),
}

SCRIPTS = [
    "tests/scripts/grid_of_walls.wws",
    "tests/scripts/crossing_that_no_double_names_and_its_nearest_double.wws",
    "tests/fuzz/corpus/parse_script/all_operations.wws",
]
MAP = "examples/maps/highground.wws"


class Fault(Exception):
    pass


def run(arguments, log, name, **options):
    """Runs a program and returns its standard output. Its other output goes to `log`."""
    with open(log, "ab") as errors:
        try:
            done = subprocess.run(
                arguments, **{"stdout": subprocess.PIPE, "stderr": errors, **options}, timeout=SECONDS, check=False
            )
        except subprocess.TimeoutExpired as late:
            raise Fault(f"{name} took more than {SECONDS} s") from late
    if done.returncode != 0:
        raise Fault(f"{name} failed: see {log.relative_to(ROOT)}")
    return done.stdout


def run_into(log, arguments, name):
    """Runs a program. All its output goes to `log`."""
    with open(log, "ab") as text:
        run(arguments, log, name, stdout=text, stderr=text)


def make_prefix():
    """Makes a folder of packages for any target: links to folders of headers, and descriptions of them for CMake."""
    prefix = FOLDER / "packages"
    shutil.rmtree(prefix, ignore_errors=True)
    (prefix / "include").mkdir(parents=True)
    for header in HEADERS:
        source = Path("/usr/include") / header
        if source.is_dir():
            (prefix / "include" / header).symlink_to(source)
    for package, (target, definition) in PACKAGES.items():
        folder = prefix / "lib" / "cmake" / package
        folder.mkdir(parents=True)
        (folder / f"{package}Config.cmake").write_text(
            f"add_library({target} INTERFACE IMPORTED)\n"
            f"set_target_properties({target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES {prefix}/include)\n"
            + (f"target_compile_definitions({target} INTERFACE {definition})\n" if definition else ""),
            encoding="utf-8",
        )
        (folder / f"{package}ConfigVersion.cmake").write_text("set(PACKAGE_VERSION_COMPATIBLE TRUE)\n", encoding="utf-8")
    return prefix


def can_run(runner):
    """Returns whether this machine has the runner and can execute it. A kernel may lack support for 32-bit programs."""
    if not runner:
        return True
    try:
        return subprocess.run([runner[0], "--version"], capture_output=True, timeout=300, check=False).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


class Build:
    def __init__(self, target, with_command, ticks):
        self.target = target
        self.ticks = ticks
        self.folder = FOLDER / target.name
        self.log = FOLDER / f"{target.name}.log"
        self.log.write_bytes(b"")
        self.with_command = with_command
        self.runner = next((each for each in target.runners if can_run(each)), None)
        self.environment = dict(os.environ, WINEDEBUG="-all", WINEPREFIX=str(FOLDER / "wine"))

    def build(self, prefix):
        (self.folder / "CMakeCache.txt").unlink(missing_ok=True)  # the locations of packages may have changed
        packages = []
        if self.target.toolchain:
            packages = [
                f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/{self.target.toolchain}.cmake",
                f"-DCMAKE_FIND_ROOT_PATH={prefix}",
                f"-DCMAKE_PREFIX_PATH={prefix}",
                "-DBoost_NO_BOOST_CMAKE=ON",
                f"-DBoost_INCLUDE_DIR={prefix}/include",
            ]
        switches = {"TESTS": "OFF", "EXAMPLES": "ON", "TOOLS": "ON" if self.with_command else "OFF"}
        run_into(
            self.log,
            ["cmake", "-S", ROOT, "-B", self.folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
            + ["-DWAYWRIGHT_WARNINGS_AS_ERRORS=ON"]
            + [f"-DWAYWRIGHT_BUILD_{part}={value}" for part, value in switches.items()]
            + packages
            + self.target.options,
            "cmake",
        )
        targets = ["waywright", "waywright_print_meshes", "lockstep_rts"]
        targets += ["waywright_command"] if self.with_command else []
        jobs = os.environ.get("WAYWRIGHT_JOBS") or str(os.cpu_count())
        run_into(self.log, ["cmake", "--build", self.folder, "--parallel", jobs, "--target", *targets], "the build")

    def output(self, program, *arguments):
        """Returns the output of a program of this build, with the line ends of Windows replaced."""
        command = [*self.runner, self.folder / (program + self.target.ending), *arguments]
        text = run(command, self.log, program, cwd=ROOT, env=self.environment)
        return text.replace(b"\r\n", b"\n") if self.target.ending == ".exe" else text

    def worlds(self):
        return self.output("tests/determinism/waywright_print_meshes")

    def game(self):
        return self.output("examples/lockstep_rts", str(self.ticks))

    def answers(self):
        command = "tools/waywright/waywright"
        dump = self.folder / "world.dump"
        picture = self.folder / "world.svg"
        files = ["--dump", dump.relative_to(ROOT), "--svg", picture.relative_to(ROOT)]
        parts = []
        for script in SCRIPTS:
            parts.append(self.output(command, "run", "--check", script, *files))
            parts += [dump.read_bytes(), picture.read_bytes()]
        converted = self.folder / "map.wws"
        self.output(command, "convert", MAP, converted.relative_to(ROOT))
        parts.append(converted.read_bytes())
        parts.append(self.output(command, "path", MAP, "--from", "60", "40", "--to", "452", "344"))
        return b"".join(parts)


class Check:
    def __init__(self, with_command, ticks):
        self.with_command = with_command
        self.ticks = ticks
        self.references = {}
        self.failed = False

    def compare(self, kind, output):
        reference = self.references.setdefault(kind, output)
        if output != reference:
            self.failed = True
            return "DIFFERENT"
        return f"{len(output):,} bytes, " + ("the reference" if output is reference else "the same")

    def row(self, target, prefix):
        if not shutil.which(target.compiler):
            return [f"skipped: no {target.compiler}"] + ["-"] * 4
        build = Build(target, self.with_command, self.ticks)
        try:
            print(f"{target.name}: building", flush=True)
            build.build(prefix)
            parts = "library and command" if self.with_command else "library"
            if build.runner is None:
                return [parts, f"no {target.runners[0][0]}", "not run", "not run", "not run"]
            print(f"{target.name}: running", flush=True)
            worlds = build.worlds()
            (FOLDER / f"{target.name}.worlds").write_bytes(worlds)
            game = build.game()
            (FOLDER / f"{target.name}.game").write_bytes(game)
            answers = self.compare("answers", build.answers()) if self.with_command else "not built"
            runner = Path(build.runner[0]).name if build.runner else "directly"
            return [parts, runner, self.compare("worlds", worlds), self.compare("game", game), answers]
        except Fault as fault:
            self.failed = True
            print(f"{target.name}: {fault}", file=sys.stderr)
            return [f"FAILED: {fault}"] + ["-"] * 4


def print_table(rows):
    rows = [["target", "what it is", "built", "run by", "200 worlds", "lockstep game", "answers of the command"], *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    rows.insert(1, ["-" * width for width in widths])
    for row in rows:
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |")


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].removeprefix("usage: "), add_help=True)
    parser.add_argument("--only", action="append", default=[], metavar="NAME")
    parser.add_argument("--no-command", action="store_true")
    parser.add_argument("--ticks", type=int, default=120, metavar="N")
    arguments = parser.parse_args()
    names = [target.name for target in TARGETS]
    unknown = [name for name in arguments.only if name not in names]
    if unknown:
        parser.error(f"no target is called '{unknown[0]}'; there are {', '.join(names)}")
    wanted = [target for target in TARGETS if target is NATIVE or not arguments.only or target.name in arguments.only]
    FOLDER.mkdir(parents=True, exist_ok=True)
    if shutil.which("ccache"):
        os.environ["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    # Emscripten uses modules of Debian's packages, which only Debian's own Node finds by itself.
    os.environ.setdefault("NODE_PATH", "/usr/share/nodejs")
    prefix = make_prefix()
    check = Check(not arguments.no_command, arguments.ticks)
    rows = [[target.name, target.about, *check.row(target, prefix)] for target in wanted]
    print()
    print_table(rows)
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
