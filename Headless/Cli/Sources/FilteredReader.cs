namespace FastPoints.Cli.Sources;

/// <summary>The points of another source that pass a filter, of all of its blocks or of some. Their counts are upper bounds.
/// It owns neither the source nor the filter.</summary>
sealed class FilteredReader : PointReader
{
    readonly IPointFilter m_filter;
    readonly IReadOnlyList<int>? m_blocks; // Null for all.
    readonly long[]? m_firstPointOfBlock;
    readonly int m_maxPointsPerBlock;

    public FilteredReader(PointReader unfiltered, IPointFilter filter)
    {
        Unfiltered = unfiltered;
        m_filter = filter;
        Info = unfiltered.Info;
        FilterHash = filter.Hash ^ 31 * unfiltered.FilterHash;
    }

    /// <param name="blocks">Ascending. The source's blocks are known.</param>
    public FilteredReader(PointReader unfiltered, IPointFilter filter, IReadOnlyList<int> blocks)
        : this(unfiltered, filter)
    {
        m_blocks = blocks;
        m_firstPointOfBlock = new long[blocks.Count + 1];
        for (int b = 0; b < blocks.Count; b++)
        {
            int points = unfiltered.PointsInBlock(blocks[b]);
            m_firstPointOfBlock[b + 1] = m_firstPointOfBlock[b] + points;
            m_maxPointsPerBlock = Math.Max(m_maxPointsPerBlock, points);
        }
    }

    internal override PointReader Unfiltered { get; }
    internal override ulong FilterHash { get; }
    public override bool BlocksAreKnown => Unfiltered.BlocksAreKnown;
    public override int BlockCount => m_blocks?.Count ?? Unfiltered.BlockCount;
    public override int MaxPointsPerBlock => m_blocks == null ? Unfiltered.MaxPointsPerBlock : m_maxPointsPerBlock;
    public override bool HasCheapRanges => Unfiltered.HasCheapRanges;
    internal override long DecoderBytes => Unfiltered.DecoderBytes;

    public override IEnumerator<JobStep> IndexBlocks()
    {
        Unfiltered.MaxIndexingJobs = MaxIndexingJobs;
        return Unfiltered.IndexBlocks();
    }

    public override long FirstPointOfBlock(int block) => m_firstPointOfBlock?[block] ?? Unfiltered.FirstPointOfBlock(block);

    public override int PointsInBlock(int block) => Unfiltered.PointsInBlock(NumberOf(block));

    public override long OrderOfBlock(int block) => Unfiltered.OrderOfBlock(NumberOf(block));

    public override string FileOfBlock(int block, out long byteOffset) =>
        Unfiltered.FileOfBlock(NumberOf(block), out byteOffset);

    public override long BytesOfRange(BlockRange range) => Unfiltered.BytesOfRange(Of(range));

    internal override bool IsRemote => Unfiltered.IsRemote;

    internal override void ListPieces(BlockRange range, List<FilePiece> pieces) => Unfiltered.ListPieces(Of(range), pieces);

    /// <returns>A slot whose batch also has the filter's attributes, after the requested ones.</returns>
    public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator)
    {
        var names = new List<string>();
        foreach (var attribute in wanted)
            names.Add(attribute.Name);
        foreach (string name in m_filter.Attributes)
            if (!names.Contains(name))
                names.Add(name);
        return new Read(this, Unfiltered.CreateRead(Info.Schema.Select(names.ToArray()), capacity, allocator));
    }

    public override void CloseFile() => Unfiltered.CloseFile();

    int NumberOf(int block) => m_blocks?[block] ?? block;

    BlockRange Of(BlockRange range) => new BlockRange(NumberOf(range.Block), range.First, range.Count);

    sealed class Read : BlockRead
    {
        readonly FilteredReader m_reader;
        readonly BlockRead m_inner;
        readonly IFilterSlot m_slot;

        public Read(FilteredReader reader, BlockRead inner)
        {
            m_reader = reader;
            m_inner = inner;
            m_slot = reader.m_filter.CreateSlot(inner.Points, reader.Info.Transform);
            Points = inner.Points;
            Result = m_slot.Result;
        }

        public override void Begin(BlockRange range)
        {
            PassOn();
            m_inner.Begin(m_reader.Of(range));
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
                : m_slot.Schedule(m_inner.Result, range, FirstPoint, m_inner.Decoded);
        }

        public override bool TryEnableStates() => m_inner.TryEnableStates();

        internal override DecoderState KeepState(DecoderState reused) => m_inner.KeepState(reused);

        internal override void Begin(BlockRange range, DecoderState from)
        {
            PassOn();
            m_inner.Begin(m_reader.Of(range), from);
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
