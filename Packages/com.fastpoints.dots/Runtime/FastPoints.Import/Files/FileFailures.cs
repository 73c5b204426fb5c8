using System;
using System.IO;
using FastPoints.Base;

namespace FastPoints.Files
{
    /// <summary>Turns the system's file exceptions into the one-line failure that the package's callers handle.</summary>
    internal static class FileFailures
    {
        // The HResult of a full disk is errno ENOSPC if the runtime passes errno on; otherwise the Windows codes
        // ERROR_DISK_FULL and ERROR_HANDLE_DISK_FULL.
        const int NoSpaceErrno = 28;
        const int DiskFull = unchecked((int)0x80070070);
        const int HandleDiskFull = unchecked((int)0x80070027);

        /// <summary>Whether <paramref name="exception"/> comes from the file system, so that <see cref="Reading"/> or
        /// <see cref="Writing"/> can describe it.</summary>
        public static bool IsFileFailure(Exception exception) =>
            exception is IOException || exception is UnauthorizedAccessException || exception is NotSupportedException
            || exception is ArgumentException || exception is System.Security.SecurityException;

        /// <summary>The failure of opening or reading <paramref name="path"/>.</summary>
        public static PointCloudException Reading(string path, Exception cause) =>
            Failure(path, cause, FailureCode.ReadFailed, "cannot be read");

        /// <summary>The failure of creating, writing or renaming <paramref name="path"/>.</summary>
        public static PointCloudException Writing(string path, Exception cause)
        {
            int code = cause.HResult;
            return code == NoSpaceErrno || code == DiskFull || code == HandleDiskFull
                ? new PointCloudException(FailureCode.DiskFull, path, -1, "the disk is full", cause)
                : Failure(path, cause, FailureCode.WriteFailed, "cannot be written");
        }

        static PointCloudException Failure(string path, Exception cause, FailureCode otherwise, string what)
        {
            if (cause is FileNotFoundException || cause is DirectoryNotFoundException)
                return new PointCloudException(FailureCode.NotFound, path, -1, "no such file or folder", cause);
            if (cause is UnauthorizedAccessException || cause is System.Security.SecurityException)
                return new PointCloudException(FailureCode.AccessDenied, path, -1, what + ": permission denied", cause);
            return new PointCloudException(otherwise, path, -1, what + ": " + cause.Message.Replace('\n', ' '), cause);
        }
    }
}
