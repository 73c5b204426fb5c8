#!/usr/bin/env bash
# The package as Unity's compiler gives it, under Debian's Mono: its tests, and conversions that must give .NET's bytes.
#   Headless/mono.sh [sgen|boehm|conversions|bench]...   all but bench where none is named
# sgen and boehm are Mono's garbage collectors; Unity's is Boehm's. bench prints what work beside frames takes of the main
# thread, under .NET and under Mono; FASTPOINTS_DATA names the folder of real clouds. As root it installs Mono by apt-get. The
# last line is "N passed, N failed, N skipped". MONO_TESTS=PATTERN runs tests whose full name contains PATTERN.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
. Headless/sdk.sh

packages="mono-runtime-sgen mono-runtime-boehm mono-devel"
has_mono() { command -v mono-sgen >/dev/null 2>&1 && command -v mono-boehm >/dev/null 2>&1 && [ -e /usr/lib/mono/4.5/Facades/netstandard.dll ]; }
if ! has_mono && [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null 2>&1; then
  apt-get update -q >/dev/null 2>&1 </dev/null
  DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $packages >/dev/null 2>&1 </dev/null
fi
parts=("$@")
[ $# -gt 0 ] || parts=(sgen boehm conversions)
if ! has_mono; then
  echo "no Mono here; with root: apt-get install $packages"
  echo "0 passed, 0 failed, ${#parts[@]} skipped"
  exit 0
fi
require_sdk mono.sh

project=Headless/MonoTests/MonoTests.csproj
built=Headless/artifacts/bin/MonoTests
adapted=Headless/artifacts/mono
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
passed=0 failed=0 skipped=0

build() {
  dotnet restore $project -v q && dotnet build $project -v q --nologo --no-restore -p:TargetFramework=net10.0 -p:RunAnalyzers=false &&
    dotnet build $project -v q --nologo --no-restore -p:TargetFramework=netstandard2.1 -p:UnityGeneration=6000.0 -p:RunAnalyzers=false &&
    rm -rf $adapted && dotnet $built/debug_net10.0/MonoTests.dll adapt $built/unity-6000.0 $adapted
}

run_tests() { # collector
  local log=$scratch/$1.log start=$SECONDS
  timeout 3600 "mono-$1" --debug $adapted/MonoTests.dll tests "${MONO_TESTS:-}" >"$log" 2>&1 </dev/null
  if [[ $(grep -E '^[0-9]+ passed' "$log" | tail -n 1) =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed,\ ([0-9]+)\ skipped$ ]]; then
    passed=$((passed + BASH_REMATCH[1])) failed=$((failed + BASH_REMATCH[2])) skipped=$((skipped + BASH_REMATCH[3]))
    grep -vE '^[0-9]+ passed|^Waiting on threads to park' "$log"
  else
    failed=$((failed + 1))
    echo "FAILED: the tests under mono-$1 broke off"
    tail -n 40 "$log"
  fi
  echo "-- tests, mono-$1: $((SECONDS - start)) s"
}

# A line for each cloud and sampler: what its files hold.
run_conversions() {
  local start=$SECONDS same other
  timeout 1800 dotnet $built/debug_net10.0/MonoTests.dll conversions "$scratch/seeded" >"$scratch/net.txt" 2>"$scratch/net.err" </dev/null ||
    { failed=$((failed + 1)); echo "FAILED: the conversions under .NET broke off"; tail -n 20 "$scratch/net.err"; }
  rm -rf "$scratch/seeded"
  timeout 3600 mono-sgen --debug $adapted/MonoTests.dll conversions "$scratch/seeded" >"$scratch/mono.txt" 2>"$scratch/mono.err" </dev/null ||
    { failed=$((failed + 1)); echo "FAILED: the conversions under Mono broke off"; tail -n 20 "$scratch/mono.err"; }
  same=$(comm -12 <(sort "$scratch/net.txt") <(sort "$scratch/mono.txt") | wc -l)
  other=$(comm -23 <(sort "$scratch/net.txt") <(sort "$scratch/mono.txt") | wc -l)
  passed=$((passed + same)) failed=$((failed + other))
  if [ "$other" -gt 0 ]; then
    echo "FAILED: $other of $((same + other)) conversions differ: < .NET, > Mono"
    diff "$scratch/net.txt" "$scratch/mono.txt" | grep '^[<>]' | head -n 40
  fi
  echo "-- conversions, mono-sgen and .NET: $((SECONDS - start)) s"
}

# What the main thread takes; jobs are managed code under both.
run_bench() {
  local runner start
  if [ -z "${FASTPOINTS_DATA:-}" ] && [ -d ../shared ]; then export FASTPOINTS_DATA=$root/../shared; fi
  for runner in "dotnet $built/debug_net10.0" "mono-boehm $adapted"; do
    start=$SECONDS
    if timeout 1800 ${runner%% *} "${runner#* }/MonoTests.dll" bench "$scratch/bench" </dev/null; then
      passed=$((passed + 1))
    else
      failed=$((failed + 1))
      echo "FAILED: the workloads under ${runner%% *} broke off"
    fi
    echo "-- frames, ${runner%% *}: $((SECONDS - start)) s"
    rm -rf "$scratch/bench"
  done
}

if ! build >"$scratch/build.log" 2>&1; then
  echo "FAILED: build of the tests for Mono"
  tail -n 40 "$scratch/build.log"
  echo "0 passed, 1 failed"
  exit 1
fi
for part in "${parts[@]}"; do
  case $part in
    sgen | boehm) run_tests "$part" ;;
    conversions) run_conversions ;;
    bench) run_bench ;;
    *) sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
