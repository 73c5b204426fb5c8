using System;
using System.Globalization;

namespace FastPoints
{
    /// <summary>A failure at the boundary (a file, the public API), described in one line: which file, at which byte, what was
    /// expected and what was found.</summary>
    public sealed class PointCloudException : Exception
    {
        public FailureCode Code { get; }

        /// <summary>The file or folder that failed.</summary>
        public string Path { get; }

        /// <summary>Byte offset in the file, or -1 if no single byte is at fault.</summary>
        public long ByteOffset { get; }

        /// <summary>The message without file and byte.</summary>
        public string What { get; }

        public PointCloudException(FailureCode code, string path, long byteOffset, string what, Exception inner = null)
            : base(Line(SourcePath.WithoutQuery(path), byteOffset, what), inner)
        {
            Code = code;
            Path = SourcePath.WithoutQuery(path);
            ByteOffset = byteOffset;
            What = what;
        }

        /// <summary>For example: <c>scan.las: at byte 96: offset to point data: wanted at least 227, got 12</c>.</summary>
        public static PointCloudException Wanted(FailureCode code, string path, long byteOffset, string field, object wanted,
            object got) =>
            new PointCloudException(code, path, byteOffset,
                string.Format(CultureInfo.InvariantCulture, "{0}: wanted {1}, got {2}", field, wanted, got));

        /// <summary>Returns a PointCloudException as it is, and wraps any other exception as an unexpected one.</summary>
        /// <param name="path">The file or folder that was being worked on.</param>
        public static PointCloudException Of(string path, Exception failure)
        {
            if (failure is AggregateException several)
                failure = several.GetBaseException();
            return failure as PointCloudException ?? new PointCloudException(FailureCode.Unexpected, path, -1,
                failure.GetType().Name + ": " + failure.Message, failure);
        }

        /// <summary>The message; for an unexpected failure, followed by the exception that was thrown, with its stack.</summary>
        public string FullMessage => Code == FailureCode.Unexpected ? Message + "\n" + InnerException : Message;

        /// <summary>Whether the input itself is at fault, and not the system around it.</summary>
        public bool IsInputAtFault =>
            Code == FailureCode.BadInput || Code == FailureCode.Truncated || Code == FailureCode.Unsupported;

        static string Line(string path, long byteOffset, string what) =>
            byteOffset < 0 ? path + ": " + what : path + ": at byte " + NumberText.Of(byteOffset) + ": " + what;
    }

    /// <summary>What kind of failure a <see cref="PointCloudException"/> reports.</summary>
    public enum FailureCode
    {
        /// <summary>The content breaks its format's rules.</summary>
        BadInput,
        /// <summary>The content ends before it should.</summary>
        Truncated,
        /// <summary>The content is valid, but of a kind that this package does not read.</summary>
        Unsupported,
        /// <summary>There is no such file or folder, or it is not a regular file.</summary>
        NotFound,
        AccessDenied,
        /// <summary>The disk failed, or the system cut a read short.</summary>
        ReadFailed,
        WriteFailed,
        DiskFull,
        /// <summary>A server's file is another one than when it was opened.</summary>
        Changed,
        /// <summary>An unexpected failure: a fault of this package, or of what it runs on.</summary>
        Unexpected,
    }
}
