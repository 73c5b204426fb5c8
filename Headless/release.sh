#!/usr/bin/env bash
# A release of the command line: a package for "dotnet tool install", and for each system an archive that needs no .NET. Each is tried
# where it can run: package and linux-x64 here, win-x64 where there is Wine. Prints sizes; their sums are in SHA256SUMS. What the
# feed of packages lacks is named and left out; with --all that is a failure. The last line is "N passed, N failed" (", N skipped").
#   Headless/release.sh [--all] [FOLDER]   default: Headless/artifacts/release; what is in it goes
set -uo pipefail
called_in=$PWD
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
. Headless/sdk.sh
all=
if [ "${1:-}" = --all ]; then all=yes; shift; fi
case "${1:-}" in -*) sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2 ;; esac
require_sdk release.sh

artifacts=$root/Headless/artifacts
folder=$artifacts/release
if [ -n "${1:-}" ]; then folder=$(cd "$called_in" && mkdir -p "$1" && cd "$1" && pwd) || exit 1; fi
build=$artifacts/release-build
packages=${NUGET_PACKAGES:-$HOME/.nuget/packages}
version=$(sed -n 's/.*"version": "\([^"]*\)".*/\1/p' Packages/com.fastpoints.dots/package.json)
rids="linux-x64 linux-arm64 osx-x64 osx-arm64 win-x64 win-arm64"
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
passed=0 failed=0 skipped=0
mkdir -p "$folder" && rm -f "$folder"/FastPoints.Cli.*.nupkg "$folder"/fastpoints-*.tar.gz "$folder"/fastpoints-*.zip "$folder/SHA256SUMS"

check() { # name, command...
  local name=$1
  shift
  if "$@" >"$scratch/check.log" 2>&1 </dev/null; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
    tail -n 20 "$scratch/check.log"
    return 1
  fi
}

skip() { # why
  skipped=$((skipped + 1))
  echo "skipped: $1"
}

finish() {
  echo "-- release: $SECONDS s"
  echo "$passed passed, $failed failed$([ "$skipped" -gt 0 ] && echo ", $skipped skipped")"
  [ "$failed" -eq 0 ]
  exit
}

cli() { # command of dotnet, kind, arguments...
  dotnet "$1" Headless/Cli/Cli.csproj -c Release -p:ReleaseAs="$2" -p:ArtifactsPath="$build/$2" -p:DebugType=none -p:RunAnalyzers=false \
    -v q --nologo "${@:3}"
}

size() { # file: megabytes, as archives are told
  awk -v bytes="$(wc -c <"$1")" 'BEGIN { printf "%.1f MB", bytes / 1e6 }'
}

# What a program holds of others: under the Apache License what says so, else under MIT's one text. The notices of .NET itself are
# in its archives only.
list_libraries() { # deps.json, whether under the Apache License
  local name spec
  while read -r name; do
    spec=$(ls "$packages/${name,,}"/*.nuspec)
    [ "$(grep -c '>Apache-2.0<' "$spec")" -eq "$2" ] &&
      echo "- ${name/\// }, $(sed -n 's/.*<authors>\(.*\)<\/authors>.*/\1/p' "$spec")"
  done < <(tr -d '\n' <"$1" | grep -oE '"[^"]+": \{ *"type": "package"' | cut -d'"' -f2)
}

write_notices() { # file, deps.json, notices of .NET
  {
    cat "Packages/com.fastpoints.dots/Third Party Notices.md"
    printf '\n## Libraries\n\nThe command line contains these under the licence below:\n\n'
    list_libraries "$2" 0
    if [ -n "$3" ]; then echo "- .NET, Microsoft"; fi
    echo
    tr -d '\r' <"$(ls "$packages"/microsoft.extensions.dependencymodel/*/LICENSE.TXT | tail -n 1)"
    printf '\nand these under the Apache License:\n\n'
    list_libraries "$2" 1
    echo
    cat Headless/Cli/Apache-2.0.txt
    if [ -n "$3" ]; then printf '\n## .NET\n\n' && tr -d '\r' <"$3"; fi
  } >"$1"
  grep -q '^- System.CommandLine' "$1" && grep -q '^- AWSSDK.S3' "$1"
}

# All that the program needs, it brings: nothing is in its environment but a folder for temporary files.
try_program() { # name, command...
  local name=$1 at=$scratch/$1
  shift
  rm -rf "$at" && mkdir -p "$at"
  run() { (cd "$at" && "$@"); }
  check "$name: demo-cloud" run "$@" demo-cloud --quiet --points 100000 --seed 5 -o cloud.laz || return
  check "$name: info" run "$@" info --quiet --scan cloud.laz
  check "$name: picture" run "$@" picture --quiet cloud.laz -o picture.png
  check "$name: convert" run "$@" convert --quiet cloud.laz -o cloud.fastpoints
  check "$name: verify" run "$@" verify --quiet cloud.fastpoints --against cloud.laz
  check "$name: the same bytes as the tool's" diff -r "$scratch/tool" "$at"
}

make_tool() {
  local notices=$scratch/THIRD-PARTY-NOTICES.txt
  check "build of the tool" cli build tool || finish
  check "notices of the tool" write_notices "$notices" "$build/tool/bin/Cli/release/FastPoints.Cli.deps.json" ""
  check "package of the tool" cli pack tool --no-build -p:ReleaseNotices="$notices" -o "$folder" || finish
  echo "FastPoints.Cli.$version.nupkg: $(size "$folder/FastPoints.Cli.$version.nupkg")"
  check "dotnet tool install" dotnet tool install --tool-path "$scratch/tools" --add-source "$folder" FastPoints.Cli --version "$version" &&
    try_program tool "$scratch/tools/fastpoints"
}

publish() { # rid
  # The ReadyToRun compiler is a package of its own: without it starts are slower, and all else is the same.
  cli publish archive -r "$1" -o "$scratch/publish-$1" || {
    grep -q 'error NU11.*Crossgen2' "$scratch/publish.log" && cli publish archive -r "$1" -o "$scratch/publish-$1" -p:PublishReadyToRun=false
  }
}

zip_folder() { (cd "$scratch" && zip -qrX "$2" "$1"); }

is_program_of() { # rid, file: by its first bytes, and for processors of ELF by their number
  local start
  start=$(od -An -tx1 -N20 "$2" | tr -d ' \n')
  case $1 in
    linux-x64) [[ $start == 7f454c46*3e00 ]] ;;
    linux-arm64) [[ $start == 7f454c46*b700 ]] ;;
    osx-x64) [[ $start == cffaedfe07000001* ]] ;;
    osx-arm64) [[ $start == cffaedfe0c000001* ]] ;;
    win-*) [[ $start == 4d5a* ]] ;;
  esac
}

make_archive() { # rid
  local rid=$1 name=fastpoints-$version-$1 program=fastpoints archive runtime
  case $rid in win-*) program=fastpoints.exe archive=$name.zip ;; *) archive=$name.tar.gz ;; esac
  if ! publish "$rid" >"$scratch/publish.log" 2>&1 </dev/null; then
    if grep -qE 'error NU11' "$scratch/publish.log"; then
      skip "$archive: $(grep -oE 'Unable to find [^.]*[A-Za-z0-9.-]+' "$scratch/publish.log" | sed 's/\.$//' | sort -u | paste -sd,)"
      if [ -n "$all" ]; then failed=$((failed + 1)); fi
    else
      failed=$((failed + 1))
      echo "FAILED: build of $archive"
      grep -E 'error' "$scratch/publish.log" | sort -u | head -n 20
    fi
    return
  fi
  mkdir -p "$scratch/$name"
  cp "$scratch/publish-$rid/FastPoints.Cli${program#fastpoints}" "$scratch/$name/$program"
  cp LICENSE Headless/Cli/README.md "$scratch/$name"
  runtime=$(ls -d "$packages/microsoft.netcore.app.runtime.$rid"/*/ | sort -V | tail -n 1)
  check "notices of $archive" write_notices "$scratch/$name/THIRD-PARTY-NOTICES.txt" \
    "$build/archive/bin/Cli/release_$rid/FastPoints.Cli.deps.json" "${runtime}THIRD-PARTY-NOTICES.TXT"
  check "$archive is one program" [ "$(ls "$scratch/publish-$rid" | grep -vc '\.pdb$')" -eq 1 ]
  check "$archive is of its system" is_program_of "$rid" "$scratch/$name/$program"
  case $archive in
    *.zip) check "$archive" zip_folder "$name" "$folder/$archive" ;;
    *) check "$archive" tar -C "$scratch" --owner=0 --group=0 --numeric-owner -czf "$folder/$archive" "$name" ;;
  esac || return
  echo "$archive: $(size "$folder/$archive"); unpacked $(size "$scratch/$name/$program")"
  rm -rf "$scratch/publish-$rid" "${scratch:?}/$name"
}

try_linux() {
  mkdir -p "$scratch/unpacked" && tar -C "$scratch/unpacked" -xzf "$folder/fastpoints-$version-linux-x64.tar.gz" &&
    try_program linux-x64 env -i TMPDIR="$scratch" "$scratch/unpacked/fastpoints-$version-linux-x64/fastpoints"
}

try_windows() {
  local wine at=$scratch/unpacked/fastpoints-$version-win-x64
  wine=$(command -v wine64 || command -v wine || ls /usr/lib/wine/wine64 2>/dev/null)
  if [ -z "$wine" ]; then skip "win-x64 is not run: no Wine here"; return; fi
  export WINEPREFIX=$scratch/wine WINEDEBUG=-all
  unzip -q "$folder/fastpoints-$version-win-x64.zip" -d "$scratch/unpacked"
  if timeout 120 "$wine" "$at/fastpoints.exe" --version >/dev/null 2>&1 </dev/null; then
    try_program win-x64 "$wine" "$at/fastpoints.exe"
  else
    skip "win-x64 is not run: .NET does not start under this Wine"
  fi
}

command -v zip >/dev/null 2>&1 || apt_install zip unzip
make_tool
for rid in $rids; do make_archive "$rid"; done
if [ "$(uname -sm)" = "Linux x86_64" ] && [ -e "$folder/fastpoints-$version-linux-x64.tar.gz" ]; then try_linux; fi
if [ -e "$folder/fastpoints-$version-win-x64.zip" ]; then try_windows; fi
(cd "$folder" && sha256sum FastPoints.Cli.*.nupkg $(ls | grep -E '^fastpoints-.*\.(tar\.gz|zip)$') >SHA256SUMS)
finish
