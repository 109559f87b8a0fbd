# SPDX-License-Identifier: GPL-3.0-or-later
"""The answers of `exact` and `filtered` hash to the same value whatever compiles them.

Usage: matrix.py SOURCE SCRATCH [QUESTIONS]

Builds what answers.cpp needs with g++ and clang++, at -O0, -O2 and -O3 -march=native, each with and without
contraction to fused multiply-add, and for aarch64, whose program runs under qemu. The programs must print the same.
"""

import concurrent.futures
import glob
import os
import shutil
import subprocess
import sys

FUSED = ["-mfma"] if os.uname().machine == "x86_64" else []  # else there is nothing to contract to
FLAGS = [
    ["-O0", "-ffp-contract=off"],
    ["-O0", *FUSED, "-ffp-contract=fast"],
    ["-O2", "-ffp-contract=off"],
    ["-O2", *FUSED, "-ffp-contract=fast"],
    ["-O3", "-march=native", "-ffp-contract=off"],
    ["-O3", "-march=native", "-ffp-contract=fast"],
]
FOREIGN = "aarch64-linux-gnu-g++"
BUILDS = [(compiler, flags) for compiler in ("g++", "clang++") for flags in FLAGS]
BUILDS += [(FOREIGN, ["-O2", "-static", "-Wno-psabi", contraction]) for contraction in ("-ffp-contract=off", "-ffp-contract=fast")]
FOLDERS = ["geometry/shapes", "geometry/contact", "robust/detail", "robust/exact", "robust/exact/detail", "robust/filtered",
           "robust/filtered/detail", "robust/filtered/detail/*"]
COMMON = ["-std=c++20", "-w", "-DCGAL_USE_GMP", "-DCGAL_USE_MPFR", "-isystem", "/usr/include/eigen3"]


def compile_file(compiler, flags, source, file, target):
    options = COMMON + flags + (["-frounding-math"] if compiler.endswith("g++") and "clang" not in compiler else [])
    if os.path.basename(file) == "answers.cpp":
        options.append("-ffp-contract=off")  # the questions are the same
    if compiler != FOREIGN and os.uname().machine == "x86_64":
        options.append("-DTOUCHSTONE_HAS_AVX2")
        if os.path.basename(file) == "kernels_avx2.cpp":
            options += ["-mavx2", "-mfma"]
    subprocess.run([compiler, *options, "-I", source, "-c", file, "-o", target], check=True)
    return target


def main():
    source, scratch = sys.argv[1:3]
    questions = sys.argv[3] if len(sys.argv) > 3 else "2000"
    files = [file for folder in FOLDERS for file in sorted(glob.glob(f"{source}/{folder}/*.cpp"))]
    files.append(f"{source}/tests/system/matrix/answers.cpp")
    answers = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, (compiler, flags) in enumerate(BUILDS):
            for needed in (compiler, "qemu-aarch64"):
                if not shutil.which(needed):
                    sys.exit(f"matrix: {needed} is not installed")
            folder = f"{scratch}/{number}-{compiler}"
            os.makedirs(folder, exist_ok=True)
            targets = [f"{folder}/{i}.o" for i in range(len(files))]
            objects = list(pool.map(lambda f, t: compile_file(compiler, flags, source, f, t), files, targets))
            program = f"{folder}/answers"
            linked = [flag for flag in flags if flag == "-static"]
            subprocess.run([compiler, *linked, *objects, "-lmpfr", "-lgmp", "-o", program], check=True)
            emulator = ["qemu-aarch64"] if compiler == FOREIGN else []
            run = subprocess.run([*emulator, program, questions], capture_output=True, text=True)
            print(compiler, *flags, "->", run.stdout.strip(), flush=True)
            if run.returncode != 0:
                sys.exit(f"matrix: exact and filtered differ: {run.stdout}{run.stderr}")
            answers[run.stdout] = (compiler, flags)
    if len(answers) != 1:
        sys.exit(f"matrix: {len(answers)} different answers")
    print("one answer")


main()
