# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Debian packages, named here only; sourced by ./run and ./test in the root of the tree.
# gcc recommends libc6-dev, which --no-install-recommends leaves out, so it is named.
ndl_build_packages="cmake ninja-build gcc libc6-dev pkg-config python3
    libassimp-dev libembree-dev libpng-dev libopenexr-dev libjansson-dev libstb-dev"
ndl_test_packages="g++ libcmocka-dev clang libclang-rt-14-dev
    glslang-tools spirv-tools python3-mpmath python3-numpy"
# To run the kernels as AArch64 and WebAssembly code; full mode only.
ndl_cross_packages="gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user
    wasi-libc libclang-rt-14-dev-wasm32 lld-14 llvm-14 nodejs"

# Installs those of the packages that are missing; without root it names them and returns 1.
ndl_install_missing() {
    local missing=() package command
    if ! command -v dpkg-query >/dev/null; then
        echo "Not a Debian system: the packages are taken to be there. In Debian's names: $*"
        return 0
    fi
    for package in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            missing+=("$package")
        fi
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    command="apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends ${missing[*]}"
    if [ "$(id -u)" != 0 ]; then
        echo "Missing packages: ${missing[*]}" >&2
        echo "Install them as root, then start again:" >&2
        echo "  $command" >&2
        return 1
    fi
    echo "Installing: ${missing[*]}"
    mkdir -p build
    export DEBIAN_FRONTEND=noninteractive
    # The lists of a fresh machine are empty or stale; those of a used one are mostly good enough.
    if ! { $command || { apt-get -o DPkg::Lock::Timeout=600 update && $command; }; } \
        >build/packages.log 2>&1; then
        tail -n 20 build/packages.log >&2
        return 1
    fi
}
