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

# What drawing on a graphics card without a window takes: the Vulkan loader, a driver that needs no card, the layer that finds
# faults, and the compiler and checker of shaders. Tests that want them are skipped without.
graphics_packages="libvulkan1 mesa-vulkan-drivers vulkan-validationlayers glslang-tools spirv-tools"

has_graphics() {
  command -v glslangValidator >/dev/null 2>&1 && command -v spirv-val >/dev/null 2>&1 &&
    { ldconfig -p 2>/dev/null | grep -q 'libvulkan\.so\.1' && ls /usr/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json 2>/dev/null | grep -q .; }
}

apt_install() { # packages...
  [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null 2>&1 &&
    apt-get update -q >/dev/null 2>&1 </dev/null &&
    DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "$@" >/dev/null 2>&1 </dev/null
}

install_graphics() {
  if has_graphics || apt_install $graphics_packages; then
    return 0
  fi
  echo "no graphics here, tests of them are skipped; with root: apt-get install $graphics_packages" >&2
}

# What Direct3D's own compiler takes: Wine, a compiler for the small program that calls it, and, by NuGet, the compiler.
direct3d_packages="wine64 gcc-mingw-w64-x86-64"

install_direct3d() {
  { { command -v wine64 >/dev/null 2>&1 || [ -x /usr/lib/wine/wine64 ]; } && command -v x86_64-w64-mingw32-gcc >/dev/null 2>&1; } ||
    apt_install $direct3d_packages ||
    echo "no Wine here, Direct3D's compiler is not run; with root: apt-get install $direct3d_packages" >&2
  dotnet restore Headless/Direct3D/Direct3D.csproj -v q >/dev/null 2>&1 </dev/null ||
    echo "the Windows SDK's package (see Headless/Direct3D) cannot be had, Direct3D's compiler is not run" >&2
}

# What makes other languages of shaders and compiles them; npm's packages for WebGPU (130 MB) lie beside what is built.
cross_packages="spirv-cross glslang-tools"

install_cross() {
  { command -v spirv-cross >/dev/null 2>&1 && command -v glslangValidator >/dev/null 2>&1; } ||
    apt_install $cross_packages ||
    echo "no spirv-cross here, shaders are not made for other APIs; with root: apt-get install $cross_packages" >&2
  mkdir -p Headless/artifacts/webgpu && cp Headless/WebGpu/package.json Headless/artifacts/webgpu &&
    npm install --prefix Headless/artifacts/webgpu --ignore-scripts --no-audit --no-fund >/dev/null 2>&1 </dev/null ||
    echo "npm's packages (see Headless/WebGpu) cannot be had, shaders are not compiled for WebGPU" >&2
}

# A web server as there are many, for clouds that are read from one.
install_nginx() {
  [ -x /usr/sbin/nginx ] || command -v nginx >/dev/null 2>&1 || apt_install nginx-light ||
    echo "no nginx here, clouds are not read from one; with root: apt-get install nginx-light" >&2
}

# A server of S3's interface.
install_s3() {
  mkdir -p Headless/artifacts/s3 && cp Headless/S3/package.json Headless/artifacts/s3 &&
    npm install --prefix Headless/artifacts/s3 --ignore-scripts --no-audit --no-fund >/dev/null 2>&1 </dev/null ||
    echo "npm's packages (see Headless/S3) cannot be had, clouds are not read from S3" >&2
}

# What reads COPC in browsers.
install_copcjs() {
  mkdir -p Headless/artifacts/copcjs && cp Headless/CopcJs/* Headless/artifacts/copcjs &&
    npm install --prefix Headless/artifacts/copcjs --ignore-scripts --no-audit --no-fund >/dev/null 2>&1 </dev/null ||
    echo "npm's packages (see Headless/CopcJs) cannot be had, COPC files are not read by copc.js" >&2
}

# What shows pages as their readers see them, and what drives it.
install_browser() {
  local version
  { command -v chromium >/dev/null 2>&1 || apt_install chromium fonts-dejavu-core; } ||
    echo "no browser here, pages are not tried in one; with root: apt-get install chromium" >&2
  version=$(sed -n 's/.*"Microsoft.Playwright" Version="\([^"]*\)".*/\1/p' Headless/Directory.Packages.props)
  find_dotnet && dotnet package download "Microsoft.Playwright@$version" --output "${NUGET_PACKAGES:-$HOME/.nuget/packages}" \
    >/dev/null 2>&1 </dev/null || echo "Playwright cannot be had, pages are not tried in a browser" >&2
}
