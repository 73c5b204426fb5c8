using System.Collections.Generic;
using FastPoints.Las;
using FastPoints.Laz;
using FastPoints.Reading;

namespace FastPoints.Export
{
    /// <summary>LAZ as LASzip writes it: chunks of one size, pointwise for point formats 0 to 5, layered above, and their
    /// table.</summary>
    internal class LazExport : LasExport
    {
        readonly LazChunkFormat m_chunkFormat;
        readonly List<int> m_bytesOfChunk = new List<int>();

        /// <param name="nodePoints">The most points of a chunk, if each has a number of its own; 0 if all have the
        /// same.</param>
        public LazExport(PointReader reader, string[] chosen, long maxPoints, int nodePoints = 0)
            : base(reader, chosen, maxPoints)
        {
            if (ExtraBytes > LazFormat.MaxExtraBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, reader.Info.Path, -1, "extra bytes of a point in LAZ",
                    "at most " + NumberText.Of(LazFormat.MaxExtraBytes), ExtraBytes);
            m_chunkFormat = LazChunkFormat.Of(Header.PointFormat, RecordBytes, nodePoints);
            BufferPoints = m_chunkFormat.ChunkPoints;
            Header.IsCompressed = true;
            AddVlr(LazItems.Vlr(m_chunkFormat.Items,
                m_chunkFormat.IsLayered ? LazCompressor.LayeredChunked : LazCompressor.PointwiseChunked,
                nodePoints > 0 ? LazFormat.VariableChunkPoints : (uint)BufferPoints));
        }

        public override LazChunkWriter CreateWriter() => new LazChunkWriter(m_chunkFormat);

        public override void OnBufferWritten(int bytes, int points) => m_bytesOfChunk.Add(bytes);

        public override byte[] Trailer() => LazChunkTable.ToBytes(m_bytesOfChunk);

        /// <summary>Behind the head of LAS stands where the table is.</summary>
        public override byte[] MakeHeader(string path, in ExportState written, long chunksEnd, long pointsEnd)
        {
            var las = base.MakeHeader(path, written, chunksEnd, pointsEnd);
            int at = las.Length;
            System.Array.Resize(ref las, at + LazChunkTable.TableOffsetSize);
            LasHeader.Put(las, at, LazChunkTable.TableOffsetSize, (ulong)chunksEnd);
            return las;
        }
    }
}
