#!/usr/bin/env bash
# The command line compiled ahead of time (NativeAOT, as IL2CPP compiles a player): nothing is made at run time, what nobody refers to
# is not there. Its clouds, samples and findings must be the ordinary build's, byte by byte; the compiler may warn of nothing in the
# package's runtime. Takes the compiler of NuGet, and gcc or clang with zlib. The last line is "N passed, N failed".
#   Headless/aot.sh
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
. Headless/sdk.sh
require_sdk aot.sh

artifacts=$root/Headless/artifacts/aot
ahead=$artifacts/fastpoints/FastPoints.Cli
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
passed=0 failed=0

check() { # name, command...
  local name=$1
  shift
  if "$@" >"$scratch/check.log" 2>&1 </dev/null; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
    tail -n 20 "$scratch/check.log"
  fi
}

skip() {
  echo "$1"
  echo "0 passed, 0 failed, 1 skipped"
  exit 0
}

command -v gcc >/dev/null 2>&1 || command -v clang >/dev/null 2>&1 || skip "no compiler for what is compiled ahead of time; with root: apt-get install gcc zlib1g-dev"
publish() {
  dotnet publish Headless/Cli/Cli.csproj -c Release -p:NativeAot=true -p:ArtifactsPath="$artifacts" -o "$artifacts/fastpoints" \
    -p:TreatWarningsAsErrors=false -p:IlcTreatWarningsAsErrors=false -p:RunAnalyzers=false -v q --nologo \
    -p:CppCompilerAndLinker="$(command -v clang >/dev/null 2>&1 && echo clang || echo gcc)" >"$scratch/publish.log" 2>&1 </dev/null
}
# Warnings of what was compiled before are not told again.
rm -rf "$artifacts/obj/Cli"
if ! publish; then
  grep -q 'error NU1[0-9]*.*[Ii][Ll][Cc]ompiler' "$scratch/publish.log" && skip "the compiler (runtime.linux-x64.Microsoft.DotNet.ILCompiler) is not to be had here"
  echo "FAILED: build ahead of time"
  tail -n 20 "$scratch/publish.log"
  echo "0 passed, 1 failed"
  exit 1
fi
none_in_the_package() { ! grep -E '/Packages/[^:]*/(Runtime|Editor|Samples~)/.*(warning|error) IL[0-9]+' "$scratch/publish.log"; }
check "warnings of the compiler" none_in_the_package
echo "what the compiler says of stand-ins, command line and benchmarks, which no player has:"
grep -oE '(Headless|UnityOutside|Packages)/[^ ]*\([0-9,]+\): [A-Za-z]+ analysis warning IL[0-9]+' "$scratch/publish.log" | sort -u | sed 's/^/  /'

both() { # folder of what comes out is $out, name of the build is $build
  local build
  for build in ahead usual; do
    out=$scratch/$build
    rm -rf "$out" && mkdir -p "$out"
    if [ $build = ahead ]; then run="$ahead"; else run=./fastpoints; fi
    "$@" || return 1
  done
  diff -r "$scratch/ahead" "$scratch/usual"
}
demo() { "$run" demo-cloud --quiet --points 300000 --seed 5 -o "$out/cloud.$1"; }
info() { "$run" info --quiet "$1" >"$out/info.txt"; }
preview() { "$run" preview --quiet "$1" -o "$out/preview.png"; }
convert() { "$run" convert --quiet --sampler "$2" "$1" -o "$out/c.fastpoints" >/dev/null && "$run" verify --quiet "$out/c.fastpoints" >/dev/null; }

./fastpoints --version >/dev/null </dev/null || exit 1
files=()
for kind in las laz ply; do
  check "demo-cloud, $kind" both demo $kind
  cp "$scratch/usual/cloud.$kind" "$scratch/seeded.$kind"
  files+=("$scratch/seeded.$kind")
done
data=${FASTPOINTS_DATA:-$root/../shared}/data
for file in lion.laz ca13_d.laz samples/copc/lone-star.copc.laz samples/potree/v2-autzen-brotli samples/ept/bcbf samples/ept/ellipsoid-zstandard \
  samples/laz/pdrf10-1.4.laz samples/las/extrabytes.las samples/ply/ripple_ascii.ply; do
  if [ -e "$data/$file" ]; then files+=("$data/$file"); fi
done
for file in "${files[@]}"; do
  check "info $file" both info "$file"
  check "preview $file" both preview "$file"
  for sampler in random poisson average; do check "convert $file, $sampler" both convert "$file" $sampler; done
done
echo "-- aot: $SECONDS s"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
