#!/usr/bin/env bash
# The package on Unity's own Entities, Collections, Mathematics, Serialization, Properties and Transforms, compiled from a folder of
# sources (Headless/Notes/outside-unity.md says what lies there) over the stand-ins of the engine: its tests, those of the host about
# entities, editor, samples and ground for com.unity.physics, and probes of its own. With Unity's IL post-processors at all
# assemblies, and with types and jobs of the package found by reflection. Safety checks are on. The last line is "N passed, N failed,
# N skipped".
#   Headless/entities.sh SOURCES [PATTERN]   PATTERN: only tests whose full name contains it
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
sources=$(cd "${1:-/nowhere}" 2>/dev/null && pwd)
cd "$root" || exit 1
. Headless/sdk.sh

skip() {
  echo "Unity's own Entities are not tried: $1 (Headless/Notes/outside-unity.md)"
  echo "0 passed, 0 failed, 1 skipped"
  exit 0
}
[ -n "$sources" ] || skip "no folder of its sources is named"
editor=$(printf '%s\n' "$sources"/6000.0.* | head -n 1)
[ -d "$editor" ] || skip "there is no 6000.0.* in $sources"
for part in UnityCsReference com.unity.{entities,collections,burst,mathematics,serialization,profiling.core}; do
  [ -d "$editor/$part" ] || skip "there is no $part in $editor"
done
require_sdk entities.sh

artifacts=$root/Headless/artifacts/entities
results=$artifacts/results
rm -rf "$results" && mkdir -p "$results"
passed=0 failed=0 skipped=0

build() { # project, options...
  dotnet build "$@" -v q --nologo -p:RealEntities="$editor" -p:ArtifactsPath="$artifacts" -p:UseSharedCompilation=true
}

stop() { # what broke off, log
  echo "FAILED: $1"
  grep -E 'error|Error' "$2" | sort -u | tail -n 40
  echo "0 passed, 1 failed"
  exit 1
}

{
  build Headless/HostTests/HostTests.csproj -restore &&
    build Headless/Package/FastPoints.Tests/FastPoints.Tests.csproj -restore -p:TargetFramework=net10.0 &&
    build UnityOutside/RealEntities/Unity.Entities.CodeGen/Unity.Entities.CodeGen.csproj -restore &&
    build UnityOutside/StandIns/Unity.Entities/Unity.Entities.csproj --no-restore -p:TargetFramework=net10.0 -p:BuildProjectReferences=false -p:ByReflection=true
} >"$results/build.log" 2>&1 </dev/null || stop "build on Unity's own Entities" "$results/build.log"
echo "-- build: $SECONDS s"

# What each way runs lies in a folder of its own.
post_process() { # folder, assemblies...
  dotnet "$artifacts/bin/Unity.Entities.CodeGen/debug/Unity.Entities.CodeGen.dll" "$@"
}
adapt() { # way
  local way=$artifacts/$1 all=$artifacts/$1/HostTests names
  rm -rf "$way" && mkdir -p "$way" &&
    cp -r "$artifacts/bin/HostTests/debug" "$all" && cp -r "$artifacts/bin/FastPoints.Tests/debug_net10.0" "$way/FastPoints.Tests" || return 1
  names="Unity.Collections Unity.Entities Unity.Entities.Hybrid Unity.Transforms Unity.Physics"
  if [ "$1" = reflection ]; then
    cp "$artifacts"/bin/Unity.Entities/reflection/Unity.Entities.{dll,pdb} "$all" || return 1
    post_process "$all" $names || return 1
  else
    names="$names $(cd "$all" && echo FastPoints*.dll HostTests.dll)"
    post_process "$all" ${names//.dll/} && post_process "$way/FastPoints.Tests" FastPoints.Tests || return 1
  fi
  for name in ${names//.dll/}; do
    if [ -e "$way/FastPoints.Tests/$name.dll" ]; then cp "$all/$name".{dll,pdb} "$way/FastPoints.Tests" || return 1; fi
  done
}
start=$SECONDS
for way in processed reflection; do
  adapt $way >"$results/$way.log" 2>&1 </dev/null || stop "post-processing ($way)" "$results/$way.log"
done
echo "-- post-processing: $((SECONDS - start)) s"

usual='TestCategory!=Long&TestCategory!=Large&TestCategory!=Direct3D&TestCategory!=Cross'
rooms='FullyQualifiedName~HostTests.Probes'
for room in Entities Editor Samples Surface.PointCloudGround StandIns.Entity StandIns.BakingTests; do rooms="$rooms|FullyQualifiedName~HostTests.$room"; done
only=${2:+&FullyQualifiedName~$2}

run_tests() { # way, assembly, filter
  local name=$1-$2 start=$SECONDS trx log=$results/$1-$2.log
  trx=$results/$name.trx
  # Both ways run at once, and make scans of the same names.
  mkdir -p "$artifacts/$1/tmp"
  TMPDIR=$artifacts/$1/tmp REAL_ENTITIES=$1 dotnet test "$artifacts/$1/$2/$2.dll" --results-directory "$results" --logger "trx;LogFileName=$name.trx" \
    --logger "console;verbosity=minimal" --filter "$3" >"$log" 2>&1 </dev/null
  echo "$? $((SECONDS - start))" >"$results/$name.ended"
}
tests_of() { # way
  run_tests "$1" FastPoints.Tests "$usual$only"
  run_tests "$1" HostTests "$usual&($rooms)$only"
}
tests_of processed &
tests_of reflection
wait

counter() { sed -n "s/.*<Counters.*[ ]$2=\"\([0-9]*\)\".*/\1/p" "$1" 2>/dev/null | head -n 1; }
for way in processed reflection; do
  for tests in FastPoints.Tests HostTests; do
    name=$way-$tests trx=$results/$way-$tests.trx
    read -r status seconds <"$results/$name.ended"
    total=$(counter "$trx" total) executed=$(counter "$trx" executed) bad=$(counter "$trx" failed)
    passed=$((passed + ${executed:-0} - ${bad:-0})) failed=$((failed + ${bad:-0})) skipped=$((skipped + ${total:-0} - ${executed:-0}))
    if [ "$status" -ne 0 ]; then
      if [ "${bad:-0}" -eq 0 ]; then failed=$((failed + 1)); echo "FAILED: $name broke off"; fi
      sed -E '/^  *Skipped /d;/^(Passed|Failed)!/d;/UnmanagedFunctionPointer/d;/^(Test run for|Starting test|A total of|VSTest version|Results File)/d' "$results/$name.log"
      sed -n "/outcome=\"Failed\"/s/.*testName=\"\([^\"]*\)\".*/FAILED: \1 ($way)/p" "$trx" 2>/dev/null
    fi
    echo "-- $name: ${executed:-0} tests, $seconds s"
  done
done
echo "-- entities: $SECONDS s"
echo "$passed passed, $failed failed$([ "$skipped" -gt 0 ] && echo ", $skipped skipped")"
[ "$failed" -eq 0 ]
