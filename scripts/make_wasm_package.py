#!/usr/bin/env python3
"""Builds the npm package in bindings/wasm: the WebAssembly module with Emscripten, and the wrapper with TypeScript
and esbuild.

usage: make_wasm_package.py

Writes the package to bindings/wasm/dist. Exits 1 if a step fails, or if the package is larger than 550 kB when it is
compressed. WAYWRIGHT_JOBS limits how many compilers run at once.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "bindings" / "wasm"
BUILD = ROOT / "build" / "wasm"
LARGEST = 550_000
# The only folders of this machine's headers that the module may use. The rest of /usr/include describes another machine.
HEADERS = ["boost", "fast_float", "fmt"]


def run(*command, cwd=ROOT):
    print("+", *command, flush=True)
    subprocess.run(command, cwd=cwd, check=True)


def make_prefix():
    """Makes a folder with links to the headers."""
    include = BUILD / "packages" / "include"
    include.mkdir(parents=True, exist_ok=True)
    for header in HEADERS:
        if not (include / header).is_symlink():
            (include / header).symlink_to(Path("/usr/include") / header)
    return include.parent


def build_module():
    prefix = make_prefix()
    if shutil.which("ccache"):
        os.environ["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    # Emscripten uses modules of Debian's packages, which only Debian's own Node finds by itself.
    os.environ.setdefault("NODE_PATH", "/usr/share/nodejs")
    switches = {"TESTS": "OFF", "EXAMPLES": "OFF", "TOOLS": "OFF", "WASM": "ON"}
    run(
        *["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "--log-level=NOTICE", "-DCMAKE_BUILD_TYPE=Release"],
        f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/cmake/toolchains/wasm_package.cmake",
        f"-DCMAKE_FIND_ROOT_PATH={prefix}",
        f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DBoost_NO_BOOST_CMAKE=ON",
        f"-DBoost_INCLUDE_DIR={prefix}/include",
        "-DWAYWRIGHT_INSTALL=OFF",
        *[f"-DWAYWRIGHT_BUILD_{part}={value}" for part, value in switches.items()],
    )
    jobs = os.environ.get("WAYWRIGHT_JOBS") or str(os.cpu_count())
    run("cmake", "--build", BUILD, "--parallel", jobs, "--target", "waywright_wasm")


def build_wrapper():
    installed, wanted = PACKAGE / "node_modules" / ".package-lock.json", PACKAGE / "package-lock.json"
    if not installed.exists() or installed.stat().st_mtime < wanted.stat().st_mtime:
        run("npm", "ci", "--no-audit", "--no-fund", cwd=PACKAGE)
    for old in (PACKAGE / "dist").rglob("*"):
        if old.suffix in (".js", ".ts"):
            old.unlink()
    run("npx", "--no-install", "tsc", "--emitDeclarationOnly", cwd=PACKAGE)
    # One file without comments and spaces, which compresses better. The comments are in the types. Messages contain
    # the names of classes.
    bundle = ["--bundle", "--format=esm", "--target=es2022", "--external:node:*", "--charset=utf8"]
    shorten = ["--minify-whitespace", "--minify-syntax", "--keep-names"]
    run("npx", "--no-install", "esbuild", "src/index.ts", *bundle, *shorten, "--outfile=dist/index.js", cwd=PACKAGE)


def compressed_size():
    """Compresses with Node, as `npm pack` does: zlib of another program makes files that differ by up to 1 % in size."""
    files = [path for path in sorted((PACKAGE / "dist").rglob("*")) if path.suffix in (".js", ".wasm")]
    program = """
        const { gzipSync } = require('node:zlib');
        const size = (file) => gzipSync(require('node:fs').readFileSync(file), { level: 9 }).length;
        console.log(process.argv.slice(1).map(size).reduce((sum, size) => sum + size, 0));
    """
    return int(subprocess.run(["node", "-e", program, *files], check=True, capture_output=True).stdout)


def main():
    try:
        build_module()
        build_wrapper()
    except subprocess.CalledProcessError as failure:
        return failure.returncode
    size = compressed_size()
    print(f"bindings/wasm/dist: {size:,} bytes, compressed")
    if size > LARGEST:
        print(f"the package is larger than {LARGEST:,} bytes", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
