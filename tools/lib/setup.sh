# Sourced by the tools: installs missing packages, configures a preset and builds it, saying so on stderr.
# shellcheck shell=bash disable=SC2034
#
# Environment: UMBRAL_PRESET   a preset of CMakePresets.json instead of the one the tool would take
#              UMBRAL_INSTALL  "no" never calls apt-get (libraries from elsewhere, or another distribution)
#              UMBRAL_JOBS     compilations at a time

umbral_root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")

# What Debian calls the libraries that the build needs; missing_packages adds the programs.
umbral_library_packages=(libembree-dev libopenexr-dev libopenimageio-dev libglm-dev libtbb-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev libboost-dev nlohmann-json3-dev libpugixml-dev
  zlib1g-dev)
umbral_test_packages=(libgtest-dev libgmock-dev chromium)
umbral_oldest_cmake=3.22

say() { printf 'umbral: %s\n' "$*" >&2; }

die() {
  printf 'umbral: error: %s\n' "$*" >&2
  exit 1
}

have() { command -v "$1" >/dev/null 2>&1; }

# The packages among the arguments that dpkg does not call installed.
not_installed() {
  local installed
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
    sed -n 's/^installed //p' || true)
  local package
  for package in "$@"; do
    grep -qxF -- "$package" <<<"$installed" || echo "$package"
  done
}

# Names the packages to install for the given libraries: those, and compiler, CMake and Ninja where absent.
missing_packages() {
  have "${CXX:-c++}" || echo g++
  have cmake || echo cmake
  have ninja || echo ninja-build
  not_installed "$@"
}

# Runs a command as root, by sudo if need be.
as_root() {
  if [[ $(id -u) == 0 ]]; then "$@"; else sudo -- "$@"; fi
}

# Turns the log of a failed apt-get into one sentence.
apt_failed() {
  local log=$1 absent
  absent=$(grep -E '^E: (Unable to locate package|Package .* has no installation candidate)' "$log" |
    grep -oE '[a-z0-9.+-]+-dev|g\+\+|cmake|ninja-build|chromium' | sort -u | tr '\n' ' ' || true)
  local unreachable='Could not (resolve|connect)|Temporary failure resolving|Network is unreachable'
  unreachable+='|Connection (timed out|refused)|Unable to connect'
  if grep -qE "$unreachable" "$log"; then
    die "apt-get cannot reach the package server: is there a network? (details: $log)"
  elif [[ -n $absent ]]; then
    die "this distribution has no package ${absent% }: Debian 12 or 13 do, main section (details: $log)"
  else
    grep -E '^(E|W|dpkg): ' "$log" | tail -n 5 >&2 || true
    die "apt-get could not install ${*:2} (details: $log)"
  fi
}

# Installs the packages named, and only them and what they depend on.
install_packages() {
  local log="$umbral_root/build/apt.log"
  local apt=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y -o DPkg::Lock::Timeout=300)
  if [[ $(id -u) != 0 ]] && ! have sudo; then
    die "to install packages I need to be root or to have sudo; have an administrator run: apt-get install $*"
  fi
  mkdir -p "$(dirname "$log")"
  say "these packages are missing; about to fetch and install them with apt-get: $*"
  [[ $(id -u) == 0 ]] || sudo -v || die "sudo refused: have an administrator run: apt-get install $*"
  as_root "${apt[@]}" update >"$log" 2>&1 || apt_failed "$log" "$@"
  local size
  size=$(LC_ALL=C apt-get install --assume-no --no-install-recommends "$@" 2>/dev/null |
    sed -nE 's/^Need to get ([^/]*[^/ ])( ?\/.*)? of archives.*/\1/p' || true)
  say "installing (${size:-size unknown} to fetch; log: $log) ..."
  as_root "${apt[@]}" install --no-install-recommends "$@" >>"$log" 2>&1 </dev/null ||
    apt_failed "$log" "$@"
}

# Makes sure that the libraries named, a compiler, CMake and Ninja are there, or says what is not.
ensure_packages() {
  if [[ ${UMBRAL_INSTALL:-yes} != no ]] && have apt-get && have dpkg-query; then
    local missing
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]} == 0)) || install_packages "${missing[@]}"
  elif ! have apt-get; then
    umbral_no_apt="There is no apt-get here: install a C++20 compiler, CMake $umbral_oldest_cmake, Ninja, and"
    umbral_no_apt+=" Embree, OpenEXR, OpenImageIO, GLM, oneTBB, toml++, CLI11, fmt, Boost.Math, nlohmann/json, pugixml, zlib"
    umbral_no_apt+=" and GoogleTest with their headers."
  fi
  have "${CXX:-c++}" || die "no C++ compiler (${CXX:-c++}). ${umbral_no_apt:-Install g++ 12 or newer.}"
  have cmake || die "no CMake. ${umbral_no_apt:-Install cmake.}"
  have ninja || die "no Ninja. ${umbral_no_apt:-Install ninja-build.}"
  check_cmake
}

check_cmake() {
  local version older
  version=$(cmake --version | sed -nE '1s/[^0-9]*([0-9.]+).*/\1/p')
  older=$(printf '%s\n' "$umbral_oldest_cmake" "$version" | sort -V | head -n 1)
  if [[ $older != "$umbral_oldest_cmake" ]]; then
    die "CMake $version ($(command -v cmake)) is too old: $umbral_oldest_cmake or newer is needed."
  fi
}

# The preset for this processor: release needs AVX2 and FMA, portable runs anywhere.
default_preset() {
  local flag
  if [[ $(uname -m) == x86_64 && -r /proc/cpuinfo ]]; then
    for flag in avx2 fma bmi1 bmi2 f16c movbe; do
      if ! grep -qm1 -w "$flag" /proc/cpuinfo; then
        say "this processor has no $flag: building the slower portable version"
        echo portable
        return
      fi
    done
  fi
  echo release
}

# Compilations at a time: one a core, but each may take 2 GB of the memory that is free or allowed.
jobs_at_a_time() {
  local cores available limit
  cores=$(nproc)
  available=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo 2>/dev/null || true)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  if [[ $limit =~ ^[0-9]+$ ]] && ((limit / 1048576 < ${available:-1048576})); then
    available=$((limit / 1048576))
  fi
  local jobs=$((${available:-2048} / 2048))
  ((jobs < cores)) || jobs=$cores
  ((jobs > 0)) || jobs=1
  echo "${UMBRAL_JOBS:-$jobs}"
}

# Ends because CMake or the compiler failed: with CMake's complaint about libraries, if that is the reason, else
# with what the log says and where it is.
build_failed() {
  local what=$1 log=$2 lacks excerpt
  lacks=$(sed -nE 's/^ *(.* was not found: install the Debian package .*)/\1/p' "$log" | paste -sd ' ')
  [[ -z $lacks ]] || die "$lacks${umbral_no_apt:+ $umbral_no_apt}"
  excerpt=$(grep -m1 -A24 '^FAILED: ' "$log" || tail -n 25 "$log")
  printf '%s\n' "$excerpt" >&2
  die "$what failed; the lines above are from $log"
}

# Deletes a build directory that was made before the tree moved here: CMake would refuse it.
drop_moved_build() {
  local directory=$1 cache="$1/CMakeCache.txt"
  [[ -e $cache ]] || return 0
  if ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$umbral_root" "$cache"; then
    say "$directory was made for another place: starting it afresh"
    rm -rf "$directory"
  fi
}

# configure PRESET DIRECTORY OPTIONS...: runs CMake unless the directory is already set up with these options.
configure() {
  local preset=$1 directory=$2 option configured=yes
  shift 2
  local cache="$directory/CMakeCache.txt" log="$directory/umbral-configure.log"
  [[ -e $directory/build.ninja ]] || configured=no
  for option in "$@"; do
    grep -qxF -- "${option#-D}" "$cache" 2>/dev/null || configured=no
  done
  [[ $configured == no ]] || return 0
  say "configuring $preset in $directory"
  mkdir -p "$directory"
  [[ -e $directory/build.ninja ]] || rm -f "$cache"
  (cd "$umbral_root" && cmake --preset "$preset" "$@") >"$log" 2>&1 || build_failed "configuring" "$log"
}

# Shows how far Ninja is: a line that rewrites itself on a terminal, else a line every tenth.
show_progress() {
  local terminal=no
  [[ ! -t 2 ]] || terminal=yes
  awk -v terminal="$terminal" '
    /Looking at the version/ { next }
    match($0, /^\[[0-9]+\/[0-9]+\]/) {
      split(substr($0, 2, RLENGTH - 2), count, "/")
      if (count[2] < 4) next
      if (terminal == "yes") { printf "\rumbral: compiling %d of %d ", count[1], count[2]; shown = 1 }
      else if (int(10 * count[1] / count[2]) > tenth) {
        tenth = int(10 * count[1] / count[2]); printf "umbral: compiling %d of %d\n", count[1], count[2]
      }
      fflush()
    }
    END { if (shown) printf "\n" }' >&2
}

# build DIRECTORY TARGET: compiles what changed.
build() {
  local directory=$1 target=$2
  local log="$directory/umbral-build.log"
  NINJA_STATUS='[%f/%t] ' cmake --build "$directory" --target "$target" --parallel "$(jobs_at_a_time)" 2>&1 |
    tee "$log" | show_progress || build_failed "compiling" "$log"
}

# Lets one build at a time into the build directory; the lock goes with the process or with unlock_builds.
lock_builds() {
  if ! { mkdir -p "$umbral_root/build" && : >>"$umbral_root/build/.lock"; } 2>/dev/null; then
    die "cannot write to $umbral_root/build: was it made by another user?"
  fi
  exec {umbral_lock}>"$umbral_root/build/.lock"
  if have flock && ! flock -n "$umbral_lock"; then
    say "waiting for another build of this tree"
    flock "$umbral_lock"
  fi
}

unlock_builds() { exec {umbral_lock}>&-; }
