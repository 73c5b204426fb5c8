using System;
using System.Runtime.CompilerServices;
using FastPoints.Base;
using StandIns.Io;

namespace FastPoints.HostTests;

/// <summary>Has what the package does with files held to Windows' rules, where these are on (FASTPOINTS_FILES=windows).</summary>
static class WindowsRules
{
#pragma warning disable CA2255
    [ModuleInitializer]
#pragma warning restore CA2255
    internal static void Follow() => FileChanges.Before = Check;

    internal static void Check(FileChange change, string path, string to)
    {
        switch (change)
        {
            case FileChange.Open:
                WindowsFiles.CheckRead(path, false);
                break;
            case FileChange.Write:
                WindowsFiles.CheckWrite(path);
                break;
            case FileChange.Replace:
                WindowsFiles.CheckReplace(path, to);
                break;
            case FileChange.Delete:
                WindowsFiles.CheckDelete(path);
                break;
            case FileChange.MoveFolder:
                WindowsFiles.CheckMoveFolder(path, to);
                break;
            case FileChange.DeleteFolder:
                WindowsFiles.CheckDeleteFolder(path);
                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(change), change, null);
        }
    }
}
