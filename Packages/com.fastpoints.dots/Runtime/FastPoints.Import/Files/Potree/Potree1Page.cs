using FastPoints.Base;

namespace FastPoints.Files
{
    /// <summary>An .hrc file that was read.</summary>
    struct Potree1Page
    {
        public ByteReader Records;
        public long FileBytes;

        /// <summary>Why it cannot be used; or null.</summary>
        public PointCloudException Problem;
    }
}
