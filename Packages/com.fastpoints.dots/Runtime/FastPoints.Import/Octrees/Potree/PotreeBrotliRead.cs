using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Octrees
{
    // Encoding BROTLI of Potree 2: one stream of all values of the first attribute, then all of the second, and so on. It is
    // decompressed and spread over the columns tile by tile, as far as the last wanted attribute.
    sealed class PotreeBrotliRead : NodeRead
    {
        // About a millisecond of Brotli.
        const int TileBytes = 256 << 10;

        struct Part
        {
            public int BytesPerPoint;
            public PotreeAttributeKind Kind;

            // In m_copies; a skipped attribute has none.
            public int FirstCopy;
            public int CopyCount;
            public bool IsWanted;
        }

        readonly List<Part> m_parts = new List<Part>();
        readonly PotreeSpecialColumns m_special;
        readonly DecompressorHandle m_decompressor;
        readonly NativeArray<FieldCopy> m_copies;
        readonly NativeArray<byte> m_tile;
        readonly NativeReference<DecompressState> m_state;

        public PotreeBrotliRead(PotreeReader reader, PointSchema wanted, int capacity, Allocator allocator)
            : base(reader, wanted, capacity, allocator)
        {
            m_special = PotreeSpecialColumns.Of(reader.Layout, Points);
            m_copies = Own(new NativeArray<FieldCopy>(PlanParts(reader.Layout).ToArray(), allocator));
            m_tile = OwnArray<byte>(TileBytes, allocator);
            m_state = Own(new NativeReference<DecompressState>(allocator));
            m_decompressor = Own(new DecompressorHandle(Decompressors.Brotli()));
        }

        List<FieldCopy> PlanParts(PotreeLayout layout)
        {
            var copies = new List<FieldCopy>();
            var attributes = layout.Attributes;
            for (int i = 0; i < attributes.Count; i++)
            {
                var attribute = attributes[i];
                var part = new Part { BytesPerPoint = attribute.Bytes, Kind = attribute.Kind, FirstCopy = copies.Count };
                foreach (var column in Points.Schema)
                    part.IsWanted |= layout.AttributeOf(column) == i;
                // Only these two names stand for Morton codes.
                if (attribute.Name == "position")
                    part.BytesPerPoint = SpreadPotreeJob.PositionBytes;
                else if (attribute.Name == "rgb" && attribute.Bytes == 6)
                    part.BytesPerPoint = SpreadPotreeJob.ColorBytes;
                else if (attribute.Kind == PotreeAttributeKind.Position || attribute.Kind == PotreeAttributeKind.Color)
                    part.Kind = PotreeAttributeKind.Plain;
                if (part.Kind != PotreeAttributeKind.Position && !attribute.IsPackedNormal)
                    copies.AddRange(layout.PlanCopies(Points, other => other == attribute, attribute.RecordOffset));
                part.CopyCount = copies.Count - part.FirstCopy;
                m_parts.Add(part);
            }
            int last = m_parts.FindLastIndex(part => part.IsWanted);
            m_parts.RemoveRange(last + 1, m_parts.Count - last - 1);
            return copies;
        }

        protected override JobHandle Schedule(BlockRange range, in NodeBlock block)
        {
            var decoded = BeginRead(range.Block, block.Offset, (int)block.Bytes);
            bool isFirst = true;
            foreach (var part in m_parts)
            {
                int tilePoints = Math.Max(1, TileBytes / part.BytesPerPoint);
                for (int first = 0; first < block.Points; first += tilePoints)
                {
                    int count = Math.Min(tilePoints, block.Points - first);
                    decoded = new DecompressJob
                    {
                        Input = File.Buffer,
                        InputBytes = (int)block.Bytes,
                        Output = m_tile,
                        Wanted = count * part.BytesPerPoint,
                        IsFirst = isFirst,
                        Slot = m_decompressor.Handle,
                        State = m_state,
                    }.Schedule(decoded);
                    isFirst = false;
                    int begin = Math.Max(first, range.First), end = Math.Min(first + count, range.First + range.Count);
                    if (part.IsWanted && begin < end)
                        decoded = Spread(part, begin - first, begin - range.First, end - begin).Schedule(decoded);
                }
            }
            return new EndPotreeJob
            {
                State = m_state,
                Result = Result,
                Points = range.Count,
                Offset = block.Offset,
            }.Schedule(decoded);
        }

        SpreadPotreeJob Spread(Part part, int firstInTile, int first, int count) => new SpreadPotreeJob
        {
            Tile = m_tile,
            Copies = m_copies,
            State = m_state,
            Columns = Points.Bytes,
            Special = m_special,
            Kind = part.Kind,
            BytesPerPoint = part.BytesPerPoint,
            FirstCopy = part.FirstCopy,
            CopyCount = part.CopyCount,
            FirstInTile = firstInTile,
            First = first,
            Count = count,
        };

        protected override void Report(DecodeResult result)
        {
            if (result.Error == PotreeError.None)
                return;
            var failure = m_decompressor.Failure;
            m_decompressor.Failure = null;
            if (failure != null)
                throw new PointCloudException(FailureCode.Unsupported, Reader.Info.Path, result.ErrorOffset,
                    "Brotli cannot be decompressed here (Decompressors.Brotli takes another decompressor): " + failure.Message,
                    failure);
            Reader.WarnBroken(Range.Block, "its Brotli stream is broken: its points are left out", null, result.ErrorOffset);
        }
    }

    // With all of its points or none, since the values of one point are spread over the whole stream.
    [BurstCompile]
    struct EndPotreeJob : IJob
    {
        [ReadOnly] public NativeReference<DecompressState> State;
        public NativeReference<DecodeResult> Result;
        public int Points;
        public long Offset;

        public void Execute()
        {
            var state = State.Value;
            Result.Value = state.IsBroken
                ? new DecodeResult { Error = PotreeError.Broken, ErrorOffset = Offset + state.Consumed }
                : new DecodeResult { Points = Points };
        }
    }
}
