using System.Collections.Generic;
using Unity.Collections;

namespace FastPoints.Reading
{
    /// <summary>The points of another source that pass a filter. Its blocks are the other's; their counts are upper
    /// bounds. It owns neither the source nor the filter.</summary>
    internal sealed class FilteredReader : PointReader
    {
        readonly PointFilter m_filter;

        public FilteredReader(PointReader unfiltered, PointFilter filter)
        {
            Unfiltered = unfiltered;
            m_filter = filter;
            Info = unfiltered.Info;
            FilterHash = filter.Hash;
        }

        internal override PointReader Unfiltered { get; }
        internal override ulong FilterHash { get; }
        public override bool BlocksAreKnown => Unfiltered.BlocksAreKnown;
        public override int BlockCount => Unfiltered.BlockCount;
        public override int MaxPointsPerBlock => Unfiltered.MaxPointsPerBlock;
        public override bool HasFixedStride => Unfiltered.HasFixedStride;
        internal override long DecoderBytes => Unfiltered.DecoderBytes;

        public override IEnumerator<JobStep> FindBlocks()
        {
            Unfiltered.MaxJobs = MaxJobs;
            return Unfiltered.FindBlocks();
        }

        public override long FirstPointOfBlock(int block) => Unfiltered.FirstPointOfBlock(block);

        public override int PointsInBlock(int block) => Unfiltered.PointsInBlock(block);

        public override long OrderOfBlock(int block) => Unfiltered.OrderOfBlock(block);

        public override string FileOfBlock(int block, out long byteOffset) => Unfiltered.FileOfBlock(block, out byteOffset);

        public override long BytesOfRange(BlockRange range) => Unfiltered.BytesOfRange(range);

        internal override bool IsRemote => Unfiltered.IsRemote;

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces) => Unfiltered.ListPieces(range, pieces);

        /// <returns>A slot whose batch also has the filter's attributes, after the requested ones.</returns>
        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
        {
            var names = new List<string>();
            foreach (var attribute in wanted)
                names.Add(attribute.Name);
            foreach (string name in m_filter.Attributes)
                if (!names.Contains(name))
                    names.Add(name);
            var read = Unfiltered.CreateRead(Info.Schema.Select(names.ToArray()), capacity, allocator);
            return new Read(read, m_filter, Info.Transform);
        }

        public override void CloseFile() => Unfiltered.CloseFile();

        sealed class Read : BlockRead
        {
            readonly BlockRead m_inner;
            readonly FilterSlot m_slot;

            public Read(BlockRead inner, PointFilter filter, in PositionTransform transform)
            {
                m_inner = inner;
                m_slot = new FilterSlot(filter, inner.Points, transform);
                Points = inner.Points;
                Result = m_slot.Result;
            }

            public override void Begin(BlockRange range)
            {
                PassOn();
                m_inner.Begin(range);
                Schedule(range);
            }

            void PassOn()
            {
                m_inner.Dependency = Dependency;
                m_inner.Fetched = TakeFetched();
            }

            void Schedule(BlockRange range)
            {
                Range = range;
                FirstPoint = m_inner.FirstPoint;
                Decoded = range.Count == 0 ? m_inner.Decoded
                    : m_slot.Schedule(m_inner.Result, FirstPoint, range.Count, m_inner.Decoded);
            }

            public override bool TryKeepStates() => m_inner.TryKeepStates();

            internal override DecoderState KeepState(DecoderState reused) => m_inner.KeepState(reused);

            internal override void Begin(BlockRange range, DecoderState from)
            {
                PassOn();
                m_inner.Begin(range, from);
                Schedule(range);
            }

            public override void Complete()
            {
                Decoded.Complete();
                m_inner.Complete();
                if (Range.Count > 0)
                    Points.Count = Result.Value.Points;
            }

            public override void Dispose()
            {
                Decoded.Complete();
                m_slot.Dispose();
                m_inner.Dispose();
            }
        }
    }
}
