#!/usr/bin/env bash
# Downloads two more Vulkan drivers and a current validation layer, from packages of Debian, to build/drivers:
#   mesa-backports/icd.json                      lavapipe of Mesa in bookworm-backports
#   swiftshader/icd.json                         SwiftShader, which chromium-common contains
#   validation/VkLayer_khronos_validation.json   the validation layer of the same package source
# The packages are only unpacked there, and apt uses a separate configuration, so the system does not change. Packages
# that exist already are kept; remove the folder to download them again. If the network or a package is missing, the
# reason is written to mesa-backports.skipped, swiftshader.skipped or validation.skipped, and the exit code is still 0.
#
#   tests/drivers/fetch.sh [FOLDER]    default: build/drivers
#   VK_DRIVER_FILES=build/drivers/mesa-backports/icd.json VK_LAYER_PATH=build/drivers/validation weft render --validate …
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${1:-$root/build/drivers}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

say() { printf '%s\n' "fetch.sh: $*" >&2; }

# skip NAME REASON: writes the reason to NAME.skipped. Does nothing if an earlier run has downloaded NAME.
skip() {
  compgen -G "$folder/$1/*.json" >/dev/null && return
  printf '%s\n' "$2" >"$folder/$1.skipped"
  say "$1 is skipped: $2"
}

# skip_all REASON: writes this reason for everything that is missing, and ends the script.
skip_all() {
  local name
  for name in mesa-backports swiftshader validation; do skip "$name" "$1"; done
  exit 0
}

# Sets up apt with package sources, lists and a cache of its own, so that the system's apt does not change.
prepare_apt() {
  local apt=$folder/apt keys=/usr/share/keyrings/debian-archive-keyring.gpg
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
  cat >"$apt/debian.sources" <<EOF
Types: deb
URIs: http://deb.debian.org/debian
Suites: bookworm bookworm-backports
Components: main
Signed-By: $keys

Types: deb
URIs: http://deb.debian.org/debian-security
Suites: bookworm-security
Components: main
Signed-By: $keys
EOF
  cat >"$apt/apt.conf" <<EOF
Dir::State::lists "$apt/lists";
Dir::Cache "$apt/cache";
Dir::Etc::sourcelist "$apt/debian.sources";
Dir::Etc::sourceparts "-";
Debug::NoLocking "true";
APT::Sandbox::User "root";
Acquire::Retries "2";
EOF
  export APT_CONFIG=$apt/apt.conf
  apt-get update -qq --error-on=any
}

# unpack PACKAGE TARGET: downloads the package and unpacks it to the folder TARGET.
unpack() {
  local scratch status=0
  scratch=$(mktemp -d "$folder/unpack-XXXXXX")
  { (cd "$scratch" && apt-get download -qq "$1") && dpkg-deb -x "$scratch"/*.deb "$scratch/files"; } >&2 || status=1
  ((status)) || mv "$scratch/files" "$2"
  rm -rf "$scratch"
  return "$status"
}

# missing_libraries LIBRARY: prints the names of the libraries that LIBRARY needs and that this machine lacks.
missing_libraries() {
  ldd "$1" | awk '/not found/ { printf "%s%s", gap, $1; gap = ", " }'
}

# finish NAME LIBRARY MANIFEST CONTENT: checks that the library can be loaded. Writes the manifest last, so that the
# manifest exists only if the library can be loaded.
finish() {
  local missing
  [ -f "$2" ] || { skip "$1" "the package holds no ${2##*/}"; return; }
  missing=$(missing_libraries "$2")
  [ -z "$missing" ] || { skip "$1" "${2##*/} needs $missing"; return; }
  mkdir -p "${3%/*}"
  printf '%s\n' "$4" >"$3"
  rm -f "$folder/$1.skipped"
  say "$1 is ready: $3"
}

# driver_manifest PATH: prints the manifest of a driver. PATH is the path of the library, relative to the
# manifest.
driver_manifest() {
  printf '{ "file_format_version": "1.0.0", "ICD": { "library_path": "%s", "api_version": "1.3.0" } }' "$1"
}

layer_manifest() {
  cat <<EOF
{
  "file_format_version": "1.2.0",
  "layer": {
    "name": "VK_LAYER_KHRONOS_validation",
    "type": "GLOBAL",
    "library_path": "$1",
    "api_version": "1.4.0",
    "implementation_version": "1",
    "description": "The Khronos validation layer of chromium-common",
    "instance_extensions": [
      { "name": "VK_EXT_debug_report", "spec_version": "9" },
      { "name": "VK_EXT_debug_utils", "spec_version": "1" },
      { "name": "VK_EXT_validation_features", "spec_version": "2" },
      { "name": "VK_EXT_layer_settings", "spec_version": "2" }
    ]
  }
}
EOF
}

fetch_mesa() {
  local name=mesa-backports
  local files=$folder/$name/files
  [ -d "$files" ] || { mkdir -p "$folder/$name" && unpack mesa-vulkan-drivers/bookworm-backports "$files"; } ||
    { skip $name "mesa-vulkan-drivers of bookworm-backports cannot be downloaded"; return; }
  finish $name "$files/usr/lib/$(uname -m)-linux-gnu/libvulkan_lvp.so" "$folder/$name/icd.json" \
    "$(driver_manifest "./files/usr/lib/$(uname -m)-linux-gnu/libvulkan_lvp.so")"
}

fetch_chromium() {
  local files=$folder/chromium/files name
  [ -d "$files" ] || { mkdir -p "$folder/chromium" && unpack chromium-common "$files"; } || {
    for name in swiftshader validation; do skip $name "chromium-common cannot be downloaded"; done
    return
  }
  finish swiftshader "$files/usr/lib/chromium/libvk_swiftshader.so" "$folder/swiftshader/icd.json" \
    "$(driver_manifest ../chromium/files/usr/lib/chromium/libvk_swiftshader.so)"
  finish validation "$files/usr/lib/chromium/libVkLayer_khronos_validation.so" \
    "$folder/validation/VkLayer_khronos_validation.json" \
    "$(layer_manifest ../chromium/files/usr/lib/chromium/libVkLayer_khronos_validation.so)"
}

ready() { [ -f "$folder/mesa-backports/icd.json" ] && [ -f "$folder/swiftshader/icd.json" ] &&
  [ -f "$folder/validation/VkLayer_khronos_validation.json" ]; }

ready && exit 0
for tool in apt-get dpkg-deb ldd; do
  command -v "$tool" >/dev/null && continue
  skip_all "this machine has no $tool"
done
trap 'rm -rf "$folder/apt"' EXIT
prepare_apt || skip_all "Debian's package lists cannot be fetched"
fetch_mesa
fetch_chromium
