namespace FastPoints.Cli.Cluster;

/// <summary>The sources of a task, opened as the plan opened all of them, and the blocks that it reads.</summary>
sealed class TaskSources : IDisposable
{
    readonly PointReader m_reader;
    readonly PointFilter? m_filter;

    TaskSources(PointReader reader, PointFilter? filter)
    {
        (m_reader, m_filter) = (reader, filter);
        Reader = filter == null ? reader : new FilteredReader(reader, filter);
    }

    public PointReader Reader { get; }

    public List<int> Blocks { get; } = []; // Ascending, of the reader.

    public List<bool> IsOwn { get; } = []; // By entry of these.

    /// <exception cref="PointCloudException">One cannot be read, or is another one than when it was planned.</exception>
    public static TaskSources Open(TaskRun task, JsonMembers json)
    {
        var sources = json.Objects("sources");
        var paths = sources.ConvertAll(s => S3Addresses.IsS3(s.Text("path")) ? S3Addresses.Add(s.Text("path")) : s.Text("path"));
        var options = task.Cloud.ReadOptions(task.Parsed);
        var reader = task.Plan.Tiles == null ? PointReaders.Open(paths[0], options)
            : TiledReader.Open(paths, path => PointReaders.OpenComplete(path, options), task.Plan.Tiles);
        try
        {
            task.Run.RunSteps(reader.IndexBlocks());
            var filter = task.Cloud.Filter(task.Parsed, reader);
            var result = new TaskSources(reader, filter);
            if ((filter?.Hash ?? 0) != task.Plan.FilterHash)
                throw new PointCloudException(FailureCode.BadInput, task.Plan.Path, -1, "its filter keeps other points by now: "
                    + "the polygon's file was changed");
            for (int s = 0; s < sources.Count; s++)
                result.Add(sources[s], paths[s], s);
            return result;
        }
        catch
        {
            reader.Dispose();
            throw;
        }
    }

    void Add(JsonMembers source, string path, int tile)
    {
        var tiles = m_reader as TiledReader;
        long bytes = tiles?.TileEntryOf(tile).FileBytes ?? m_reader.Info.FileBytes;
        if (bytes != source.NonNegative("bytes"))
            throw PointCloudException.Wanted(FailureCode.BadInput, path, -1, "it was changed after it was planned: bytes",
                source.NonNegative("bytes"), bytes);
        var (first, count) = tiles?.BlocksOf(tile) ?? (0, m_reader.BlockCount);
        foreach (var range in source.LongLists("blocks", 3))
        {
            if (range[0] < 0 || range[0] > range[1] || range[1] > count)
                throw source.Wanted("blocks", "ranges of " + count + " blocks");
            for (long block = range[0]; block < range[1]; block++)
            {
                Blocks.Add(first + (int)block);
                IsOwn.Add(range[2] != 0);
            }
        }
    }

    public void Dispose()
    {
        m_filter?.Dispose();
        m_reader.Dispose();
    }
}
