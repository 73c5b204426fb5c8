using FastPoints.Core;
using Unity.Collections;

namespace FastPoints.Reading
{
    sealed class FixedRecords
    {
        public readonly SourceHandle File;
        public readonly PointFields Fields;
        public readonly long DataOffset;
        public readonly int RecordBytes;
        public readonly bool IsBigEndian;

        public FixedRecords(SourceHandle file, PointFields fields, long dataOffset, int recordBytes, bool isBigEndian = false)
        {
            File = file;
            Fields = fields;
            DataOffset = dataOffset;
            RecordBytes = recordBytes;
            IsBigEndian = isBigEndian;
        }

        public long OffsetOf(long point) => DataOffset + point * RecordBytes;

        public NativeArray<FieldCopy> CopiesTo(PointBatch batch, Allocator allocator) =>
            new NativeArray<FieldCopy>(FieldCopyPlan.Make(Fields, batch, IsBigEndian), allocator);
    }
}
