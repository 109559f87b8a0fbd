# SPDX-License-Identifier: GPL-3.0-or-later
"""A new, minimal Debian, which mmdebstrap makes from the sources of this machine's packages."""

import os
import pathlib
import platform
import shlex
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from running import run  # noqa: E402


def sources():
    """The files from which apt installs on this machine."""
    folder = pathlib.Path("/etc/apt")
    return [path for path in [folder / "sources.list", *sorted((folder / "sources.list.d").glob("*.*"))]
            if path.exists() and path.suffix in (".list", ".sources")]


def run_in_clean_root(packages, given, script, answers, made=None):
    """Returns what `script`, a file of the folder `given`, prints in a new Debian that has these packages, and that folder
    at its root, and no variables of this environment but those of proxies. What it prints is also in the file `answers`.
    The folder /made, if it makes one, comes into `made`."""
    proxies = [f"{name}={value}" for name, value in os.environ.items() if name.lower().endswith("_proxy")]
    clean = shlex.join(["env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "HOME=/root", "LC_ALL=C.UTF-8",
                        "DEBIAN_FRONTEND=noninteractive", *proxies])
    run("mmdebstrap", "--variant=minbase", "--format=null", "--quiet", f"--include={','.join(packages)}",
        f"--customize-hook=copy-in {given} /",
        f"--customize-hook=chroot \"$1\" {clean} sh /{given.name}/{script} >'{answers}'",
        *([f"--customize-hook=copy-out /made {made}"] if made else []),
        platform.freedesktop_os_release()["VERSION_CODENAME"], "/dev/null", *sources())
    return answers.read_text()
