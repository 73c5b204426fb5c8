using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Las
{
    internal sealed class LasRecordLayout
    {
        // recordBytes: according to the header, at least the format's own; extra: described bytes, with offsets from the record's
        // start. The rest of the record becomes columns of single bytes named ExtraBytes[i], so that no part of a record is lost.
        public LasRecordLayout(LasPointFormat format, int recordBytes, IEnumerable<PointField> extra)
        {
            Format = format;
            RecordBytes = recordBytes;
            foreach (var field in format.Fields)
                Fields.Add(field);
            int end = format.RecordBytes;
            foreach (var field in extra)
            {
                Fields.Add(field);
                end = field.ByteOffset + field.Type.SizeOf();
            }
            DescribedBytes = end;
            for (int i = end; i < recordBytes; i++)
                Fields.Add(new PointField("ExtraBytes[" + NumberText.Of(i - end) + "]", AttributeType.UInt8, i));

            Schema = Fields.ToSchema();
        }

        public LasPointFormat Format { get; }
        public int RecordBytes { get; }

        // End of the last byte that the format or a description covers.
        public int DescribedBytes { get; }

        public PointFields Fields { get; } = new PointFields();
        public PointSchema Schema { get; }
    }
}
