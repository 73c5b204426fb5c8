namespace FastPoints.Cli.Cluster;

/// <summary>What a plan is made by, beside the sources.</summary>
/// <param name="IsBucketed">Null for what seems cheaper.</param>
/// <param name="Divisor">Of all attributes; 0 for what the sample shows.</param>
sealed record PlanRequest(string Path, string Store, IReadOnlyList<string> Settings, long TaskPoints, bool? IsBucketed,
    int Divisor, long MemoryBytes);

/// <summary>Plans the tasks of a build over many machines, by headers and a sample.</summary>
sealed class PlanStep
{
    /// <summary>Where all tasks together read more than this times the points, it is cheaper to read them once, and to write
    /// each to the bucket of its task. That takes 0.4 of a build; of LAS, whose points cost little, 2 reads take no more than
    /// one.</summary>
    const double MostReads = 1.5, MostReadsOfCheapRanges = 3;
    const double MemoryOfBucket = 0.6; // A bucket's records take so much of a task's memory, so that they are written once.

    const string TaskStage = "tasks";

    sealed class Reads
    {
        public readonly List<(int Piece, bool IsOwn)> Pieces = [];
        public long Points;
    }

    readonly PlanRequest m_request;
    readonly CloudPlan m_plan;
    readonly PointReader m_reader;
    readonly SourcePieces m_sources;
    readonly GridCube[] m_cubes;
    readonly double[] m_points;

    readonly (int First, int Last)[] m_buckets; // By piece.

    PlanStep(PlanRequest request, CloudPlan plan, PointReader reader)
    {
        m_request = request;
        m_plan = plan;
        m_reader = reader;
        m_sources = SourcePieces.Of(reader.Unfiltered, plan.Whole.Grid);
        m_cubes = plan.CubesOf(request.TaskPoints);
        m_points = PointsOf(plan, m_cubes);
        m_buckets = new (int, int)[m_sources.Pieces.Count];
        if (request.Divisor > 0)
            Array.Fill(plan.Whole.Divisors, request.Divisor);
    }

    public double ReadsPerPoint { get; private set; } // Points that all tasks read, of those that there are.

    public static (BuildPlan Plan, double ReadsPerPoint) Run(PointReader reader, ConvertSettings settings, PlanRequest request,
        CliRun run)
    {
        CloudPlan? made = null;
        run.RunSteps(ConvertCloud.Plan([reader], settings,
            (build, values, records) => made = CloudPlan.Of(build, values, records), run.Progress));
        run.Progress.Begin(TaskStage);
        var step = new PlanStep(request, made!, reader);
        var result = step.Write();
        run.Progress.End();
        return (result, step.ReadsPerPoint);
    }

    static double[] PointsOf(CloudPlan plan, GridCube[] cubes)
    {
        var points = new double[cubes.Length];
        int cube = 0;
        for (int cell = 0; cell < plan.Whole.BaseCells.Length; cell++)
        {
            while (!cubes[cube].ContainsAligned(plan.Whole.BaseCells[cell]))
                cube++;
            points[cube] += plan.PointsOfCell[cell];
        }
        return points;
    }

    BuildPlan Write()
    {
        var reads = ReadsOfTasks();
        long points = Math.Max(1, m_reader.PointCount);
        ReadsPerPoint = reads.Sum(r => r.Points) / (double)points;
        double most = m_reader.HasCheapRanges ? MostReadsOfCheapRanges : MostReads;
        bool isBucketed = m_request.IsBucketed ?? (ReadsPerPoint > most && m_cubes.Length > 1);
        // Of cubes without sources nothing comes, unless records of buckets turn out to lie there.
        var kept = Enumerable.Range(0, m_cubes.Length).Where(t => isBucketed || t == 0 || reads[t].Pieces.Count > 0).ToArray();
        var buckets = isBucketed ? Buckets() : [];
        var builds = BuildAssignment.Of(Array.ConvertAll(kept, t => m_points[t]), m_request.TaskPoints);
        var merges = MergeTree.Of(m_plan.Whole.CloudCube, kept.Select((t, number) => (builds.NameOf(number), m_cubes[t])));
        var plan = NewPlan(builds, buckets.Count, merges, Estimate(isBucketed, kept, reads, builds));
        string text = plan.ToTextAndSetHash(), parts = BuildPlan.PartsOf(m_request.Path);
        Clear(m_request.Path, parts);
        OutputFile.MakeFolder(parts);
        for (int number = 0; number < kept.Length; number++)
            WriteBuild(plan, number, kept[number], reads[kept[number]]);
        var buildsOf = BuildsOfBuckets(buckets.Count, reads);
        for (int number = 0; number < buckets.Count; number++)
            WritePart(plan, TaskNames.Bucket(number), json =>
            {
                WriteSources(json, buckets[number].Select(p => (p, true)));
                WriteNumbers(json, "builds", buildsOf[number]);
            });
        foreach (var merge in merges.SelectMany(round => round))
            WritePart(plan, merge.Name, json => WriteMerge(json, merge));
        if (isBucketed)
            WritePart(plan, BuildPlan.CubesName, json =>
                PlanFile.WriteCubes(json, "cubes", m_cubes));
        WriteFacts(parts);
        OutputFile.Write(m_request.Path, Encoding.UTF8.GetBytes(text));
        return plan;
    }

    /// <summary>Each block belongs to the first task that reads it.</summary>
    Reads[] ReadsOfTasks()
    {
        var reads = Array.ConvertAll(m_cubes, _ => new Reads());
        var index = new CubeFinder(m_plan.Whole.CloudCube, m_cubes);
        var found = new List<int>();
        for (int p = 0; p < m_sources.Pieces.Count; p++)
        {
            var piece = m_sources.Pieces[p];
            found.Clear();
            index.Find(piece.Min, piece.Max, found);
            if (found.Count == 0)
                found.Add(0);
            foreach (int task in found)
            {
                reads[task].Pieces.Add((p, task == found[0]));
                reads[task].Points += piece.Points;
            }
        }
        return reads;
    }

    /// <summary>Consecutive blocks of about as many points as a task builds.</summary>
    List<List<SourcePiece>> Buckets()
    {
        var buckets = new List<List<SourcePiece>>();
        long room = 0;
        for (int p = 0; p < m_sources.Pieces.Count; p++)
        {
            var piece = m_sources.Pieces[p];
            for (int block = 0; block < piece.Blocks;)
            {
                if (room <= 0)
                {
                    buckets.Add([]);
                    room = Math.Min(m_request.TaskPoints, (long)(MemoryOfBucket * m_request.MemoryBytes)
                        / m_plan.Whole.RecordLayout.StrideBytes);
                }
                m_buckets[p] = (block == 0 ? buckets.Count - 1 : m_buckets[p].First, buckets.Count - 1);
                var part = piece;
                (part.FirstBlock, part.FirstOfAll) = (piece.FirstBlock + block, piece.FirstOfAll + block);
                (part.Blocks, part.Points) = (0, 0);
                while (block < piece.Blocks && (part.Blocks == 0 || room > 0))
                {
                    int points = m_reader.Unfiltered.PointsInBlock(piece.FirstOfAll + block);
                    (part.Blocks, part.Points, room, block) = (part.Blocks + 1, part.Points + points, room - points, block + 1);
                }
                buckets[^1].Add(part);
            }
        }
        return buckets;
    }

    PlanEstimate Estimate(bool isBucketed, int[] kept, Reads[] reads, BuildAssignment builds)
    {
        long points = m_reader.PointCount;
        double share = points / Math.Max(1, m_points.Sum());
        var tasks = Enumerable.Range(0, builds.BuildTasks);
        return PlanEstimate.Of(points, m_plan.Whole.RecordLayout.StrideBytes, tasks.Select(task =>
            builds.Of(task).Select(b => kept[b]).Select(t =>
                (m_points[t] * share, isBucketed ? (long)(m_points[t] * share) : reads[t].Points))), m_request.MemoryBytes,
            isBucketed);
    }

    BuildPlan NewPlan(BuildAssignment builds, int buckets, List<List<MergeTask>> merges, PlanEstimate estimate)
    {
        return new BuildPlan
        {
            Path = m_request.Path,
            Store = m_request.Store,
            Settings = m_request.Settings,
            FilterHash = m_reader.FilterHash,
            Tiles = m_reader.Unfiltered is TiledReader ? m_reader.Info : null,
            Whole = m_plan.Whole,
            Cloud = m_plan.Manifest,
            Builds = builds,
            BucketTasks = buckets,
            MergeTasks = merges.ConvertAll(round => round.Count),
            Estimate = estimate,
        };
    }

    static void Clear(string path, string parts) => OutputFile.WithFileErrors(path, () =>
    {
        // Without its index it is none any more.
        File.Delete(path);
        if (Directory.Exists(parts))
            Directory.Delete(parts, true);
    });

    void WriteBuild(BuildPlan plan, int number, int task, Reads reads)
    {
        var part = m_plan.Whole.Of(m_cubes[task]);
        WritePart(plan, plan.Builds.NameOf(number), json =>
        {
            json.WritePropertyName("cube");
            PlanFile.WriteCube(json, part.Cube);
            PlanFile.WriteCubes(json, "cells", part.BaseCells);
            json.WriteNumber("points", (long)m_points[task]);
            if (plan.BucketTasks == 0)
            {
                WriteSources(json, reads.Pieces.Select(p => (m_sources.Pieces[p.Piece], p.IsOwn)));
                return;
            }
            WriteNumbers(json, "buckets", BucketsOf(reads));
        });
    }

    IEnumerable<long> BucketsOf(Reads reads)
    {
        var buckets = new SortedSet<long>();
        foreach (var (piece, _) in reads.Pieces)
            for (int bucket = m_buckets[piece].First; bucket <= m_buckets[piece].Last; bucket++)
                buckets.Add(bucket);
        return buckets;
    }

    List<long>[] BuildsOfBuckets(int count, Reads[] reads)
    {
        var builds = Enumerable.Range(0, count).Select(_ => new List<long>()).ToArray();
        for (int task = 0; count > 0 && task < reads.Length; task++)
            foreach (long bucket in BucketsOf(reads[task]))
                builds[bucket].Add(task);
        return builds;
    }

    static void WriteNumbers(Utf8JsonWriter json, string name, IEnumerable<long> numbers)
    {
        json.WritePropertyName(name);
        json.WriteNumbers([.. numbers]);
    }

    void WriteSources(Utf8JsonWriter json, IEnumerable<(SourcePiece Piece, bool IsOwn)> pieces)
    {
        json.WriteObjects("sources", pieces.GroupBy(p => p.Piece.File).OrderBy(g => g.Key), ofFile =>
        {
            var (path, bytes) = m_sources.Files[ofFile.Key];
            json.WriteString("path", S3Addresses.NameOf(SourcePath.Full(path)));
            json.WriteNumber("bytes", bytes);
            json.WriteArray("blocks", Joined(ofFile.OrderBy(p => p.Piece.FirstBlock)),
                blocks => json.WriteNumbers(blocks.First, blocks.End, blocks.IsOwn ? 1 : 0));
        });
    }

    static IEnumerable<(int First, int End, bool IsOwn)> Joined(IEnumerable<(SourcePiece Piece, bool IsOwn)> pieces)
    {
        (int First, int End, bool IsOwn) range = default;
        foreach (var (piece, isOwn) in pieces)
        {
            if (range.End == piece.FirstBlock && range.IsOwn == isOwn)
            {
                range.End += piece.Blocks;
                continue;
            }
            if (range.End > range.First)
                yield return range;
            range = (piece.FirstBlock, piece.FirstBlock + piece.Blocks, isOwn);
        }
        if (range.End > range.First)
            yield return range;
    }

    static void WriteMerge(Utf8JsonWriter json, MergeTask merge)
    {
        json.WritePropertyName("cube");
        PlanFile.WriteCube(json, merge.Cube);
        json.WriteArray("inputs", merge.Inputs, json.WriteStringValue);
    }

    static void WritePart(BuildPlan plan, string name, Action<Utf8JsonWriter> members) =>
        OutputFile.Write(plan.PathOf(name + ".json"), Encoding.UTF8.GetBytes(PlanFile.ToText(json =>
        {
            json.WriteString("plan", PlanFile.ToHex(plan.Hash));
            members(json);
        })));

    void WriteFacts(string parts)
    {
        OutputFile.Write(Path.Combine(parts, StoreFormat.SourcesName),
            StoredSources.ToParts(CloudDescription.SourcesOf(m_reader)).Select(Encoding.UTF8.GetBytes));
        OutputFile.Write(Path.Combine(parts, StoreFormat.FactsName), Encoding.UTF8.GetBytes(StoredFacts.ToJson(m_reader.Info)));
        if (m_plan.LasMetadata != null)
            OutputFile.Write(Path.Combine(parts, StoreFormat.RecordsName), m_plan.LasMetadata);
    }
}
