namespace FastPoints.Base
{
    /// <summary>What kind of failure a <see cref="PointCloudException"/> reports.</summary>
    public enum FailureCode
    {
        /// <summary>The content breaks its format's rules.</summary>
        BadInput,
        /// <summary>The content ends before it should.</summary>
        Truncated,
        /// <summary>The content is sound, but of a kind that is not read here.</summary>
        Unsupported,
        /// <summary>No such file or folder, or not a regular file.</summary>
        NotFound,
        AccessDenied,
        /// <summary>The disk failed or a read was cut short by the system.</summary>
        ReadFailed,
        WriteFailed,
        DiskFull,
        /// <summary>Nobody foresaw it: a fault of this package, or of what it runs on.</summary>
        Unexpected,
    }
}
