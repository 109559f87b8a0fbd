# SPDX-License-Identifier: Apache-2.0
# For aarch64 on a Debian of another architecture: `need_packages emulation` of .ci/packages installs the compiler, GMP
# and MPFR. The other libraries are headers alone, so the packages of this machine serve.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)  # g++ would note how arguments were passed before g++ 10
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(CMAKE_PREFIX_PATH /usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/cmake)
