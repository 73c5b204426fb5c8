using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;

namespace FastPoints.Export
{
    internal abstract class ExportFormat
    {
        public readonly List<ExportColumn> Columns = new List<ExportColumn>();

        public readonly PointField[] Axes = new PointField[3];

        public readonly List<string> Warnings = new List<string>();

        public readonly List<Loss> Losses = new List<Loss>();

        /// <summary>A change that is no loss, such as another point format; null for none.</summary>
        public string Note { get; protected set; }

        public PositionConversion Position;

        public int RecordBytes { get; protected set; }

        public int BufferPoints { get; protected set; }

        public int ReturnMask { get; protected set; }

        public virtual bool NeedsBounds => false; // Whether SetBounds has to be called before the first record.

        public virtual void SetBounds(in ExportState measured) { }

        /// <summary>Whether each block of the source starts a buffer of its own: its number is the range's
        /// <see cref="ExportRange.Node"/>.</summary>
        public bool HasBufferPerNode { get; protected set; }

        /// <summary>The ranges that will be written, in this order; a format may complete them.</summary>
        public virtual void SetRanges(List<ExportRange> ranges) { }

        public virtual void Configure(in ExportRange range, ref MakeRecordsJob job) { }

        /// <summary>Parts of the source that are copied behind the points: the first byte, and the number of bytes.</summary>
        public virtual IReadOnlyList<(long Offset, long Bytes)> Tail => System.Array.Empty<(long, long)>();
        public virtual IReadOnlyList<byte[]> TailBytes => System.Array.Empty<byte[]>(); // What comes behind that.

        /// <summary>All that comes before the points, of a length that is always the same.</summary>
        /// <param name="written">The points; none before they are written.</param>
        /// <param name="chunksEnd">Where <see cref="Trailer"/> begins.</param>
        /// <param name="pointsEnd">Where the tail begins.</param>
        public abstract byte[] MakeHeader(string path, in ExportState written, long chunksEnd, long pointsEnd);

        /// <summary>What compresses buffers, one at a time; null for records as they are.</summary>
        public virtual LazChunkWriter CreateWriter() => null;

        /// <summary>Called for each buffer, in the file's order.</summary>
        public virtual void OnBufferWritten(int bytes, int points) { }

        public virtual byte[] Trailer() => System.Array.Empty<byte>();

        /// <summary>A column for each axis, of the source's type and in its place.</summary>
        protected void SetAxes(AttributeType type)
        {
            string[] names = { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            for (int axis = 0; axis < 3; axis++)
                Axes[axis] = new PointField(names[axis], type, axis * type.SizeOf());
        }

        /// <summary>The header and records of the LAS files that the source was made from; null if it has none.</summary>
        protected LasMetadata LasRecordsOf(PointReader reader)
        {
            try
            {
                return reader is ConvertedReader stored ? LasMetadata.Read(stored.RecordsPath)
                    : reader is TiledReader tiles ? LasMetadata.CommonTo(tiles.Paths, Losses) : null;
            }
            catch (PointCloudException e)
            {
                Losses.Add(new Loss("header and records of LAS files", reader.Info.Path, e.Message));
                return null;
            }
        }

        protected static bool IsAxis(string name) =>
            name == AttributeNames.X || name == AttributeNames.Y || name == AttributeNames.Z;

        protected static bool IsChosen(string name, string[] chosen) =>
            chosen == null || System.Array.IndexOf(chosen, name) >= 0;
    }

    internal sealed class ExportColumn
    {
        public string From;
        public PointField To;
        public double Scale = 1; // Written = read * Scale + Offset, at most Max.
        public double Offset;
        public double Max = double.PositiveInfinity;

        public bool IsSame(AttributeType from) =>
            from == To.Type && Scale == 1 && Offset == 0 && double.IsPositiveInfinity(Max);
    }

    internal sealed class ExportResult
    {
        public readonly long Points;
        public long PointsRead; // Points that were read, chosen or not.
        public long PointsLeftOut; // Chosen points whose position is no number, or does not fit the file.
        public readonly long Bytes;

        /// <summary>The farthest that a coordinate was moved, in CRS units; 0 if they are the source's own numbers.</summary>
        public readonly double PositionError;

        public readonly string Note;
        public readonly List<string> Warnings; // One line each.

        public readonly List<Loss> Losses;

        public ExportResult(ExportFormat format, in ExportState state, long bytes)
        {
            Points = state.Written;
            PointsRead = state.Seen;
            PointsLeftOut = state.LeftOut;
            Bytes = bytes;
            PositionError = state.MaxPositionError;
            Note = format.Note;
            Warnings = new List<string>(format.Warnings);
            Losses = new List<Loss>(format.Losses);
            if (state.Clamped > 0)
                Warnings.Add(NumberText.Of(state.Clamped) + " values are larger than their fields in LAS: the largest that " +
                    "fits is written");
        }
    }
}
