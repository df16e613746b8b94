#!/usr/bin/env bash
# Runs the two commands of the README in a fresh Debian 12 installation in a folder (a chroot): `./weft render`, then
# `./weft test`. An ordinary CI machine has many packages, so it can hide that the README misses an install step; a
# fresh installation cannot. Needs root, debootstrap and a package mirror. Prints how long each step took, and exits
# with an error if a step fails.
#   tests/bare_machine.sh [--keep] [--render-only]
#     --keep         keep the folder of the installation and print its path
#     --render-only  skip `./weft test`
# WEFT_BARE_MIRROR package mirror [default: the host's first mirror, or else http://deb.debian.org/debian]
# WEFT_BARE_TARBALL archive of the fresh installation: created if it does not exist, unpacked if it does
set -euo pipefail

source_root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
suite=bookworm
keep=0
run_tests=1
for arg in "$@"; do
  case $arg in
    --keep) keep=1 ;;
    --render-only) run_tests=0 ;;
    *) printf 'usage: %s [--keep] [--render-only]\n' "$0" >&2; exit 2 ;;
  esac
done

say() { printf 'bare machine: %s\n' "$*" >&2; }
fail() { say "FAILED: $*"; exit 1; }

[ "$(id -u)" -eq 0 ] || fail "run this as root: it makes a root and enters it"
command -v git >/dev/null || fail "git is needed to clone the repository"

work=$(mktemp -d "${TMPDIR:-/tmp}/weft-bare.XXXXXX")
bare=$work/root
mounts=()

clean_up() {
  local status=$? i failed=0
  trap - EXIT INT TERM
  for ((i = ${#mounts[@]} - 1; i >= 0; --i)); do
    umount "${mounts[i]}" 2>/dev/null || umount --lazy "${mounts[i]}" || failed=1
  done
  if ((keep)); then
    say "kept in $bare"
  elif ((failed)) || grep -q " $bare/" /proc/self/mounts; then
    say "something is still mounted below $bare, so it is left in place"
  else
    rm -rf --one-file-system "$work"
  fi
  exit "$status"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# timed NAME COMMAND...: runs the command, and prints and records how long it took.
timings=()
timed() {
  local name=$1 begin=$SECONDS status=0
  shift
  "$@" || status=$?
  timings+=("$name: $((SECONDS - begin)) s")
  say "${timings[-1]}"
  return "$status"
}

# Prints the host's first mirror of the Debian packages. Reads both formats of apt's source files.
host_mirror() {
  {
    sed -n 's/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list /etc/apt/sources.list.d/*.list
    sed -n 's/^URIs: *\([^ ]*\).*/\1/p' /etc/apt/sources.list.d/*.sources
  } 2>/dev/null | grep -v security | head -n 1
}

make_root() {
  local tarball=${WEFT_BARE_TARBALL:-} mirror
  mkdir "$bare"
  if [ -n "$tarball" ] && [ -f "$tarball" ]; then
    tar -xpf "$tarball" -C "$bare" --numeric-owner
    return
  fi
  command -v debootstrap >/dev/null || fail "debootstrap is needed: apt-get install debootstrap"
  mirror=${WEFT_BARE_MIRROR:-$(host_mirror || true)}
  debootstrap --variant=minbase "$suite" "$bare" "${mirror:-http://deb.debian.org/debian}" >"$work/debootstrap.log" 2>&1 ||
    { tail -n 20 "$work/debootstrap.log" >&2; fail "debootstrap"; }
  if [ -n "$tarball" ]; then tar -cpf "$tarball" -C "$bare" --numeric-owner .; fi
}

# Copies the host's package sources, proxies, keys and name resolution into the chroot.
share_network() {
  local entry
  for entry in sources.list sources.list.d apt.conf apt.conf.d trusted.gpg trusted.gpg.d keyrings auth.conf auth.conf.d; do
    rm -rf "$bare/etc/apt/$entry"
    [ -e "/etc/apt/$entry" ] || continue
    cp -aL "/etc/apt/$entry" "$bare/etc/apt/$entry"
  done
  [ ! -d /usr/share/keyrings ] || cp -aL /usr/share/keyrings/. "$bare/usr/share/keyrings/"
  for entry in resolv.conf hosts ssl/certs; do
    [ -e "/etc/$entry" ] || continue
    mkdir -p "$(dirname "$bare/etc/$entry")"
    rm -rf "${bare:?}/etc/$entry"
    cp -aL "/etc/$entry" "$bare/etc/$entry"
  done
}

# mount_into TYPE_OR_BIND TARGET: mounts TARGET in the chroot, as a bind mount or as a file system of this
# type.
mount_into() {
  mkdir -p "$bare$2"
  if [ "$1" = bind ]; then mount --bind "$2" "$bare$2"; else mount -t "$1" "$1" "$bare$2"; fi
  mounts+=("$bare$2")
}

enter_root() {
  mount_into proc /proc
  mount_into bind /dev
  [ ! -d /dev/pts ] || mount_into bind /dev/pts
  # With this script, installed packages start no services in the chroot.
  printf '#!/bin/sh\nexit 101\n' >"$bare/usr/sbin/policy-rc.d"
  chmod +x "$bare/usr/sbin/policy-rc.d"
}

# Clones the repository into the chroot. So only committed files are used, as by a new user.
clone_repository() {
  git clone --quiet --no-hardlinks -c safe.directory="*" "$source_root" "$bare/root/weft"
  say "commit $(git -C "$bare/root/weft" log -1 --format='%h %s')"
}

# inside COMMAND: runs the command in the chroot. Only the proxy variables of the host's environment are passed on.
inside() {
  local name environment=(HOME=/root USER=root LANG=C.UTF-8 TERM=dumb
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [ -z "${!name:-}" ] || environment+=("$name=${!name}")
  done
  env -i "${environment[@]}" chroot "$bare" /bin/bash -c "cd /root/weft && $1"
}

# Checks the size of the picture in pixels, and of the file in bytes: a black or uniform picture has only a few
# kilobytes.
check_picture() {
  local picture=$bare/root/weft/frame.png width height
  [ -s "$picture" ] || fail "no frame.png was written"
  [ "$(head -c 8 "$picture" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || fail "frame.png is not a PNG"
  width=$((0x$(od -An -tx1 -j16 -N4 "$picture" | tr -d ' \n')))
  height=$((0x$(od -An -tx1 -j20 -N4 "$picture" | tr -d ' \n')))
  [ "${width}x$height" = 1280x720 ] || fail "frame.png is ${width}x$height, not 1280x720"
  [ "$(stat -c %s "$picture")" -gt 100000 ] || fail "frame.png is so small that it must be (nearly) one colour"
  say "frame.png: ${width}x$height, $(stat -c %s "$picture") bytes, sha256 $(sha256sum "$picture" | cut -c1-16)…"
}

# Checks that the test packages are not installed yet, because `./weft render` needs no test framework.
check_no_test_packages() {
  local package
  for package in $(awk '/^test_packages=\(/ { inside = 1; next } /^\)/ { inside = 0 } inside' "$source_root/weft" |
    sed 's/^ *"\([^:]*\):.*/\1/'); do
    # Other packages depend on python3, so it may be installed already.
    [ "$package" != python3 ] || continue
    ! inside "dpkg-query -W -f='\${db:Status-Status}' $package 2>/dev/null | grep -qx installed" ||
      fail "./weft render installed $package, which only tests need"
  done
}

timed "make the root" make_root
share_network
enter_root
clone_repository
timed "./weft render" inside "./weft render" || fail "./weft render"
check_picture
check_no_test_packages
timed "./weft render again" inside "./weft render" || fail "the second ./weft render"
if ((run_tests)); then timed "./weft test" inside "./weft test" || fail "./weft test"; fi
say "passed on $(nproc) cores"
printf '%s\n' "${timings[@]}"
