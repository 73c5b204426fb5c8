# Sourced by fastpoints, test and .ci/run: finds the .NET SDK, or says what is missing and how to get it.

export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1 DOTNET_SKIP_FIRST_TIME_EXPERIENCE=1 MSBUILDTERMINALLOGGER=off

# A dotnet that no package manager put on the PATH lies in DOTNET_ROOT or in the user's home.
find_dotnet() {
  local candidate
  for candidate in "$(command -v dotnet 2>/dev/null)" "${DOTNET_ROOT:-}/dotnet" "$HOME/.dotnet/dotnet"; do
    if [ -n "$candidate" ] && [ -x "$candidate" ]; then
      if [ -z "${DOTNET_ROOT:-}" ]; then
        DOTNET_ROOT=$(dirname "$(readlink -f "$candidate")")
        export DOTNET_ROOT
      fi
      export PATH="$(dirname "$candidate"):$PATH"
      return 0
    fi
  done
  return 1
}

require_sdk() {
  if find_dotnet && dotnet --list-sdks 2>/dev/null | grep -q '^10\.'; then
    return 0
  fi
  {
    if command -v dotnet >/dev/null 2>&1; then
      echo "$1: the .NET 10 SDK is missing (found: $(dotnet --list-sdks 2>/dev/null | cut -d' ' -f1 | paste -sd' ' -))."
    else
      echo "$1: the .NET 10 SDK is missing (there is no dotnet on the PATH, in DOTNET_ROOT or in ~/.dotnet)."
    fi
    echo "It is all that is needed. How to get it:"
    echo "  Ubuntu, Debian   sudo apt-get install dotnet-sdk-10.0"
    echo "  Fedora           sudo dnf install dotnet-sdk-10.0"
    echo "  macOS            brew install --cask dotnet-sdk"
    echo "  Windows          winget install Microsoft.DotNet.SDK.10   (then run this from Git Bash)"
    echo "  without root     the dotnet-install script, with: --channel 10.0   (it installs into ~/.dotnet)"
  } >&2
  exit 1
}
