using System;
using System.IO;
using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>Turns the system's file exceptions into the one-line failure that the package's callers handle.</summary>
    internal static class FileFailures
    {
        /// <summary>Windows, and runtimes on it, may refuse paths from this length on, and say that something is
        /// missing.</summary>
        const int LongPath = 260;

        /// <summary>Whether <paramref name="exception"/> comes from the file system, so that <see cref="Reading"/> or
        /// <see cref="Writing"/> can describe it.</summary>
        public static bool IsFileFailure(Exception exception) =>
            exception is IOException || exception is UnauthorizedAccessException || exception is NotSupportedException
            || exception is ArgumentException || exception is System.Security.SecurityException;

        /// <summary>The failure of opening or reading <paramref name="path"/>.</summary>
        public static PointCloudException Reading(string path, Exception cause) =>
            Failure(path, cause, FailureCode.ReadFailed, "cannot be read");

        /// <summary>The failure of creating, writing or renaming <paramref name="path"/>.</summary>
        public static PointCloudException Writing(string path, Exception cause) => FileChanges.IsDiskFull(cause)
            ? new PointCloudException(FailureCode.DiskFull, path, -1, "the disk is full", cause)
            : Failure(path, cause, FailureCode.WriteFailed, "cannot be written");

        static PointCloudException Failure(string path, Exception cause, FailureCode otherwise, string what)
        {
            if (cause is FileNotFoundException || cause is DirectoryNotFoundException)
                return new PointCloudException(FailureCode.NotFound, path, -1, "no such file or folder" + (path.Length < LongPath
                    ? "" : ": the path has " + path.Length + " characters, where Windows takes " + (LongPath - 1)), cause);
            if (cause is UnauthorizedAccessException || cause is System.Security.SecurityException)
                return new PointCloudException(FailureCode.AccessDenied, path, -1, what + ": permission denied", cause);
            return new PointCloudException(otherwise, path, -1, what + ": " + cause.Message.Replace('\n', ' '), cause);
        }
    }
}
