#!/usr/bin/env bash
# Builds the fuzz targets and runs each for some seconds, starting with the inputs in tests/fuzz/corpus. An input that
# causes a fault is stored in build/fuzz/found/, and the run fails. Add such an input to the corpus together with the
# correction.
#   run.sh SECONDS [graph|gltf|image|spirv]...
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:?seconds for each target}
shift
targets=("$@")
((${#targets[@]})) || targets=(graph gltf image spirv)
build=$root/build/fuzz

cd "$root"
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
mkdir -p "$build"
{ cmake --preset fuzz "${launcher[@]}" && cmake --build --preset fuzz; } >"$build/build.log" 2>&1 || {
  cat "$build/build.log" >&2
  exit 1
}

status=0
for target in "${targets[@]}"; do
  # New inputs are stored outside the source tree, and the next run starts with them too.
  learnt=$build/corpus/$target found=$build/found/$target
  mkdir -p "$learnt" "$found"
  # tinyexr leaks memory in broken files (see image_fuzzer.cpp), so a leak check after each input would be slow. For
  # images, leaks are checked only once, at the end.
  leaks=1
  [ "$target" != image ] || leaks=0
  words=()
  [ ! -f "tests/fuzz/$target.dict" ] || words=(-dict="tests/fuzz/$target.dict")
  log=$build/$target.log result=passed
  "$build/tests/fuzz/${target}_fuzzer" "$learnt" "tests/fuzz/corpus/$target" "${words[@]}" \
    -max_total_time="$seconds" -max_len=1048576 -rss_limit_mb=1024 -malloc_limit_mb=1024 -timeout=5 -detect_leaks=$leaks \
    -artifact_prefix="$found/" -print_final_stats=1 >"$log" 2>&1 || result=FAILED
  executions=$(awk '/^stat::number_of_executed_units/ { print $2 }' "$log")
  echo "$target: $result, ${executions:-0} executions in $seconds s, $(find "$found" -type f | wc -l) found"
  if [ "$result" != passed ]; then
    tail -60 "$log" >&2
    status=1
  fi
done
exit $status
