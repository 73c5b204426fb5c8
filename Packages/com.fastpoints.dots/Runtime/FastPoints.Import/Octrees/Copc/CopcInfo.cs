using FastPoints.Core;
using FastPoints.Las;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // The copc info VLR (COPC 1.0), the first of a file, so that its data starts at byte 429; other places are tolerated.
    internal sealed class CopcInfo
    {
        public const string UserId = "copc";
        public const ushort InfoRecord = 1;
        public const ushort HierarchyRecord = 1000;
        public const int Bytes = 160;

        // The others are reserved.
        const int FieldBytes = 72;

        // In CRS units, like all lengths here.
        public double3 Center;

        public double HalfSize;

        // Of the root; it halves from level to level.
        public double Spacing;

        public ulong RootPageOffset;
        public ulong RootPageBytes;
        public double MinGpsTime;
        public double MaxGpsTime;
        public long FileOffset;

        public BoundsGeo Cube => new BoundsGeo(Center - HalfSize, Center + HalfSize);

        // Null if the file has no such VLR.
        public static CopcInfo Find(LasFile las)
        {
            var record = las.Vlrs.Find(UserId, InfoRecord);
            if (record == null)
                return null;
            var bytes = las.Vlrs.Payload(record);
            var info = new CopcInfo { FileOffset = record.DataOffset };
            if (!bytes.Has(0, FieldBytes))
                return info;
            for (int axis = 0; axis < 3; axis++)
                info.Center[axis] = bytes.Float64(8 * axis, "center");
            info.HalfSize = bytes.Float64(24, "halfsize");
            info.Spacing = bytes.Float64(32, "spacing");
            info.RootPageOffset = bytes.UInt64(40, "root page offset");
            info.RootPageBytes = bytes.UInt64(48, "root page size");
            info.MinGpsTime = bytes.Float64(56, "smallest GPS time");
            info.MaxGpsTime = bytes.Float64(64, "largest GPS time");
            return info;
        }

        // Null if it is fit for use.
        public string Problem(long fileBytes)
        {
            if (!Cube.IsFinite || !(HalfSize > 0))
                return "the octree's cube is none (half of its edge is " + NumberText.Of(HalfSize) + ")";
            if (RootPageOffset > (ulong)fileBytes || RootPageBytes > (ulong)fileBytes - RootPageOffset)
                return "the root page of the hierarchy would lie at byte " + NumberText.Of(RootPageOffset) + " with "
                    + NumberText.Of(RootPageBytes) + " bytes, the file has " + NumberText.Of((ulong)fileBytes);
            return RootPageBytes < CopcEntry.Bytes
                ? "the root page of the hierarchy has " + NumberText.Of(RootPageBytes) + " bytes, wanted at least "
                    + CopcEntry.Bytes
                : null;
        }

        public void AddFacts(SourceInfo info)
        {
            info.Fact("COPC version", "1.0");
            info.Fact("COPC center", NumberText.Of(Center.x) + " " + NumberText.Of(Center.y) + " " + NumberText.Of(Center.z));
            info.Fact("COPC half size", NumberText.Of(HalfSize));
            info.Fact("COPC spacing", NumberText.Of(Spacing));
            info.Fact("COPC root page", NumberText.Of(RootPageBytes) + " bytes at byte " + NumberText.Of(RootPageOffset));
            info.Fact("COPC GPS time", NumberText.Of(MinGpsTime) + " to " + NumberText.Of(MaxGpsTime));
        }
    }
}
