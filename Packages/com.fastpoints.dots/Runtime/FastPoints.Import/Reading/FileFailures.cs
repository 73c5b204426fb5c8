using System;
using System.IO;
using FastPoints.Core;

namespace FastPoints.Reading
{
    internal static class FileFailures
    {
        // Windows, and runtimes on it, may refuse paths from this length on, and say that something is missing.
        const int LongPath = 260;

        public static bool IsFileFailure(Exception exception) =>
            exception is IOException || exception is UnauthorizedAccessException || exception is NotSupportedException
            || exception is ArgumentException || exception is System.Security.SecurityException;

        public static PointCloudException Reading(string path, Exception cause) =>
            Failure(path, cause, FailureCode.ReadFailed, "cannot be read");

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
