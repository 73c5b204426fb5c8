@echo off
rem Builds the command line on its first start (and when a source file is newer), then runs it: fastpoints.cmd --help
rem The same for Windows as fastpoints is for bash; what changes in one changes in the other.
setlocal EnableExtensions DisableDelayedExpansion
set "root=%~dp0"
set "out=%root%Headless\artifacts\fastpoints"
set "binary=%out%\FastPoints.Cli.exe"
set "DOTNET_CLI_TELEMETRY_OPTOUT=1"
set "DOTNET_NOLOGO=1"
set "DOTNET_SKIP_FIRST_TIME_EXPERIENCE=1"
set "MSBUILDTERMINALLOGGER=off"

rem Real clouds for bench, where a checkout has them beside it.
if not defined FASTPOINTS_DATA if exist "%root%..\shared\" set "FASTPOINTS_DATA=%root%..\shared"
call :find_dotnet
call :is_stale && call :build
if not exist "%binary%" exit /b 1
if defined broken exit /b 1
"%binary%" %*
exit /b %errorlevel%

rem A dotnet that no installer put on the PATH lies in DOTNET_ROOT or in the user's home.
:find_dotnet
set "found="
for %%d in (dotnet.exe) do set "found=%%~dp$PATH:d"
if defined found goto found_dotnet
if defined DOTNET_ROOT if exist "%DOTNET_ROOT%\dotnet.exe" set "found=%DOTNET_ROOT%\"
if not defined found if exist "%USERPROFILE%\.dotnet\dotnet.exe" set "found=%USERPROFILE%\.dotnet\"
if not defined found exit /b 1
set "PATH=%found%;%PATH%"
:found_dotnet
if not defined DOTNET_ROOT if exist "%found%shared\Microsoft.NETCore.App\" set "DOTNET_ROOT=%found%"
exit /b 0

rem 0 where it is. Folders count as well: their time changes when a file in them is deleted. cmd cannot compare times, PowerShell can.
:is_stale
if not exist "%out%\built" exit /b 0
if not exist "%binary%" exit /b 0
set "look=$built = (Get-Item -LiteralPath ($env:out + '\built')).LastWriteTimeUtc;"
set "look=%look% foreach ($part in 'Headless\Cli', 'UnityOutside\StandIns', 'Headless\Package', 'Headless\Directory.Build.props',"
set "look=%look% 'Headless\Directory.Packages.props', 'Packages\com.fastpoints.dots\package.json',"
set "look=%look% 'Packages\com.fastpoints.dots\Runtime', 'Packages\com.fastpoints.dots\Benchmarks') {"
set "look=%look% $at = $env:root + $part; foreach ($item in @(Get-Item -LiteralPath $at) + @(Get-ChildItem -LiteralPath $at -Recurse)) {"
set "look=%look% if ($item.LastWriteTimeUtc -gt $built -and $item.Extension -ne '.meta') { exit 0 } } } exit 1"
powershell -NoLogo -NoProfile -NonInteractive -Command "%look%" <nul >nul 2>nul
exit /b %errorlevel%

:build
set "broken=yes"
call :require_sdk
if errorlevel 1 exit /b 1
if not exist "%out%\" mkdir "%out%"
set "why=first start: compiles the package and the command line, once, in half a minute"
if exist "%out%\built" set "why=the sources have changed, some 30 s"
echo building fastpoints (%why%); what it says goes to %out%\build.log 1>&2
del /q "%out%\begun" 2>nul
type nul >"%out%\begun"
rem The ReadyToRun compiler is a package of its own: without it starts are slower, and all else is the same.
call :publish
if errorlevel 1 call :publish -p:PublishReadyToRun=false
if errorlevel 1 goto failed
move /y "%out%\begun" "%out%\built" >nul
set "broken="
echo built 1>&2
exit /b 0

:failed
findstr "error" "%out%\build.log" 1>&2
echo fastpoints: the build failed; all that it said is in %out%\build.log 1>&2
exit /b 1

:publish
rem Code analysis is for ./test: it would cost the first start half its time.
dotnet publish "%root%Headless\Cli\Cli.csproj" -c Release -o "%out%" -v q --nologo -p:RunAnalyzers=false %* <nul >"%out%\build.log" 2>&1
exit /b %errorlevel%

:require_sdk
set "sdk="
for /f "delims=" %%v in ('dotnet --list-sdks 2^>nul ^| findstr /b "10\."') do set "sdk=%%v"
if defined sdk exit /b 0
echo fastpoints: the .NET 10 SDK is missing (looked for a dotnet on the PATH, in DOTNET_ROOT and in %USERPROFILE%\.dotnet). 1>&2
echo It is all that is needed. How to get it: 1>&2
echo   winget install Microsoft.DotNet.SDK.10 1>&2
exit /b 1
