#!/bin/bash
# Sees to the Debian packages that the build needs; with "tests" also those of the tests, with "ci" those of .ci/run.
# Installs what is missing where it may (root, or sudo without a password), else names it in one line. Never fails: what
# is really missing is named by cmake.
set -u

packages=(g++ cmake ninja-build git ca-certificates libopenmpi-dev openmpi-bin libeigen3-dev libhdf5-dev libgsl-dev libfftw3-dev
          libfmt-dev libgtest-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev libssl-dev librandom123-dev libhwy-dev
          musl-dev libmseed-dev libxlsxwriter-dev
          node-d3-zoom)  # goes into pages: figures zoom, tables sort; without it they are whole and still
for wish in "$@"; do
    case $wish in
        tests) packages+=(python3-h5py python3-numpy python3-matplotlib python3-jsonschema  # another reading of our files; figures
                          python3-openpyxl python3-pandas python3-xarray python3-netcdf4 python3-h5netcdf hdf5-tools  # and further ones
                          slurmctld slurmd slurm-client slurm-wlm-basic-plugins munge  # a cluster to test on
                          qemu-user) ;;  # other CPUs to test on
        ci) packages+=(ccache clang-format clang-tidy libbenchmark-dev libboost-dev  # and what benchmarks compare with
                       libmpich-dev  # another MPI to build with
                       chromium groff-base  # pages as others see them
                       python3-sphinx furo python3-myst-parser libjs-mathjax) ;;  # the manual
        *) echo "setup: '$wish' (unknown). Use tests or ci" >&2; exit 2 ;;
    esac
done

if ! command -v dpkg-query >/dev/null; then
    echo "setup: no Debian packages on this machine; the libraries are taken as they are" >&2
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo -n)
fi
if ! command -v apt-get >/dev/null || ! "${as_root[@]}" true 2>/dev/null; then
    echo "setup: missing here: ${missing[*]} (no right to install). Let an administrator run: apt-get install ${missing[*]}" >&2
    exit 0
fi

echo "setup: installing ${missing[*]}"
quietly=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0)
"${as_root[@]}" "${quietly[@]}" update >/dev/null || echo "setup: not every package list could be renewed; going on" >&2
if ! "${as_root[@]}" "${quietly[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null; then
    echo "setup: not everything could be installed (see above); going on" >&2
fi
exit 0
