# SPDX-License-Identifier: GPL-3.0-or-later
"""The answers of `exact` and `filtered` hash to the same value whatever compiles them.

Usage: matrix.py SOURCE SCRATCH [QUESTIONS]

Builds geometry, robust and answers.cpp with g++ and clang++, at -O0, -O2 and -O3 -march=native, the last with and
without contraction to fused multiply-add, and compares what the programs print.
"""

import concurrent.futures
import glob
import os
import shutil
import subprocess
import sys

COMPILERS = ["g++", "clang++"]
FLAGS = [
    ["-O0", "-ffp-contract=off"],
    ["-O2", "-ffp-contract=off"],
    ["-O3", "-march=native", "-ffp-contract=off"],
    ["-O3", "-march=native", "-ffp-contract=fast"],
]
COMMON = ["-std=c++20", "-w", "-DCGAL_USE_GMP", "-DCGAL_USE_MPFR", "-isystem", "/usr/include/eigen3"]


def compile_file(compiler, flags, source, file, target):
    options = COMMON + flags + (["-frounding-math"] if compiler == "g++" else [])
    if os.path.basename(file) == "answers.cpp":
        options.append("-ffp-contract=off")  # the questions are the same
    if os.path.basename(file) == "engine_avx2.cpp":
        options += ["-mavx2", "-mfma"]
    if os.uname().machine == "x86_64":
        options += ["-DTOUCHSTONE_HAS_AVX2"]
    subprocess.run([compiler, *options, "-I", source, "-c", file, "-o", target], check=True)
    return target


def main():
    source, scratch = sys.argv[1:3]
    questions = sys.argv[3] if len(sys.argv) > 3 else "2000"
    files = [f for f in glob.glob(f"{source}/robust/**/*.cpp", recursive=True) if "/proofs/" not in f]
    files += glob.glob(f"{source}/geometry/shapes/*.cpp") + glob.glob(f"{source}/geometry/contact/*.cpp")
    files.append(f"{source}/tests/matrix/answers.cpp")
    answers = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for compiler in COMPILERS:
            if not shutil.which(compiler):
                sys.exit(f"matrix: {compiler} is not installed")
            for number, flags in enumerate(FLAGS):
                folder = f"{scratch}/{compiler}-{number}"
                os.makedirs(folder, exist_ok=True)
                targets = [f"{folder}/{i}.o" for i in range(len(files))]
                objects = list(pool.map(lambda f, t: compile_file(compiler, flags, source, f, t), files, targets))
                program = f"{folder}/answers"
                subprocess.run([compiler, *objects, "-lmpfr", "-lgmp", "-o", program], check=True)
                run = subprocess.run([program, questions], capture_output=True, text=True)
                print(compiler, *flags, "->", run.stdout.strip(), flush=True)
                if run.returncode != 0:
                    sys.exit(f"matrix: exact and filtered differ: {run.stdout}{run.stderr}")
                answers[run.stdout] = (compiler, flags)
    if len(answers) != 1:
        sys.exit(f"matrix: {len(answers)} different answers")
    print("one answer")


main()
