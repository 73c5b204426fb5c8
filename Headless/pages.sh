#!/usr/bin/env bash
# For ./test --pages: the pages that the command line writes in a real browser, and its COPC files by a browser's reader. The last line is "N passed, N failed".
# "build" and "run" do half of it each: what runs needs neither network nor compiler, and can go beside other builds.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. Headless/sdk.sh
require_sdk test
results=Headless/artifacts/page-results
if [ "${1:-}" != run ]; then
  rm -rf "$results" && mkdir -p "$results"
  install_browser
  install_copcjs
  # A property said here would be everybody's, and all be compiled again, here and by the next ./test.
  dotnet build Headless/PageTests/PageTests.csproj -v q --nologo >"$results/build.log" 2>&1 </dev/null ||
    { tail -n 20 "$results/build.log"; echo "0 passed, 1 failed"; exit 1; }
fi
if [ "${1:-}" = build ]; then exit 0; fi
dotnet test Headless/artifacts/bin/PageTests/debug/PageTests.dll --results-directory "$results" --logger "trx;LogFileName=pages.trx" \
  --logger "console;verbosity=normal" >"$results/pages.log" 2>&1 </dev/null
status=$?
counter() { sed -n "s/.*<Counters.*[ ]$1=\"\([0-9]*\)\".*/\1/p" "$results/pages.trx" 2>/dev/null | head -n 1; }
total=$(counter total) executed=$(counter executed) bad=$(counter failed)
if [ "$status" -ne 0 ] && [ "${bad:-0}" -eq 0 ]; then bad=1 executed=$((${executed:-0} + 1)); fi
if [ "${bad:-0}" -gt 0 ]; then cat "$results/pages.log"; else grep -m 1 "apt-get install" "$results/pages.log"; fi
skipped=$((${total:-0} - ${executed:-0}))
echo "$((${executed:-0} - ${bad:-0})) passed, ${bad:-0} failed$([ "$skipped" -gt 0 ] && echo ", $skipped skipped")"
[ "${bad:-0}" -eq 0 ]
