using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Export
{
    /// <summary>Writes the points of any source as LAS, LAZ, COPC or PLY, in the order of the source, or of its octree: all, or
    /// those within boxes, of some classes, or of an octree's upper levels. Memory does not depend on the source's
    /// size.</summary>
    internal sealed class ExportCloud : IDisposable
    {
        readonly PointReader m_reader;
        readonly ExportSettings m_settings;
        readonly StageProgress m_progress;
        readonly List<ExportRange> m_ranges;
        readonly PointSchema m_wanted;
        readonly ExportFormat m_format;
        NativeReference<ExportState> m_state = new NativeReference<ExportState>(Allocator.Persistent);
        NativeArray<LocalClip> m_clips;
        NativeArray<ulong> m_classes;
        NativeArray<byte> m_converted;
        NativeArray<int> m_chosen;
        long m_filled;
        NativeArray<ulong> m_noBuffers = new NativeArray<ulong>(0, Allocator.Persistent);

        ExportCloud(PointReader reader, ExportSettings settings, ExportFormat format, List<ExportRange> ranges,
            StageProgress progress)
        {
            m_reader = reader;
            m_settings = settings;
            m_format = format;
            m_ranges = ranges;
            m_progress = progress;
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            foreach (var column in format.Columns)
                names.Add(column.From);
            if (settings.Classes != null)
                names.Add(AttributeNames.Classification);
            if (settings.Filter != null)
                names.AddRange(settings.Filter.Attributes);
            m_wanted = reader.Info.Schema.Select(names.ToArray());
            m_clips = new NativeArray<LocalClip>(settings.LocalClips(), Allocator.Persistent);
            m_classes = new NativeArray<ulong>(settings.Classes == null ? 0 : 4, Allocator.Persistent);
            foreach (int c in settings.Classes ?? Array.Empty<int>())
                m_classes[c >> 6] |= 1ul << (c & 63);
            m_converted = new NativeArray<byte>((3 + format.Columns.Count) * 8 * MakeRecordsJob.PointsPerSlice,
                Allocator.Persistent);
            m_chosen = new NativeArray<int>(MakeRecordsJob.PointsPerSlice, Allocator.Persistent);
        }

        /// <summary>Coroutine. The file is there, whole, when it has ended; cancelled or failed, it leaves
        /// nothing.</summary>
        /// <param name="path">Its ending says what is written.</param>
        /// <exception cref="PointCloudException">The source or the target is at fault.</exception>
        public static IEnumerator<JobStep> Run(PointReader reader, string path, ExportSettings settings,
            Action<ExportResult> done,
            StageProgress progress)
        {
            path = Path.GetFullPath(path);
            reader.Info.ThrowIfInConflict();
            if (!reader.BlocksAreKnown)
            {
                progress?.Begin("find points");
                yield return JobStep.Of(reader.IndexBlocks());
            }
            yield return JobStep.Of(PoolTask.Run(path, () => ExportRange.ThrowIfSource(reader, path), _ => { }));
            if (CopcExport.IsNamed(path) && !CopcExport.CanExport(reader))
            {
                yield return JobStep.Of(RunConverted(reader, path, settings, done, progress));
                yield break;
            }
            List<ExportRange> ranges = null;
            ExportFormat format = null;
            yield return JobStep.Of(PoolTask.Run(path, () => FormatOf(reader, path, settings), made => format = made));
            yield return JobStep.Of(PoolTask.Run(path, () => ExportRange.Choose(reader, settings), made => ranges = made));
            format.SetRanges(ranges);
            using var export = new ExportCloud(reader, settings, format, ranges, progress);
            yield return JobStep.Of(export.SetBounds());
            progress?.Begin("export");
            yield return JobStep.Of(export.Write(path, done));
            progress?.End();
        }

        /// <summary>Coroutine: converts the source to a temporary cloud beside the target first. An export to the same target
        /// resumes the conversion of one that was killed.</summary>
        static IEnumerator<JobStep> RunConverted(PointReader reader, string path, ExportSettings settings,
            Action<ExportResult> done, StageProgress progress)
        {
            string octree = path + CopcExport.OctreeSuffix;
            CheckClasses(reader, settings);
            var attributes = settings.Attributes == null ? null : new List<string>(settings.Attributes);
            if (settings.Classes != null)
                attributes?.Add(AttributeNames.Classification);
            foreach (string name in settings.Filter?.Attributes ?? Array.Empty<string>())
                if (!(name is AttributeNames.X or AttributeNames.Y or AttributeNames.Z))
                    attributes?.Add(name);
            var build = new ConvertSettings
            {
                Attributes = attributes?.ToArray(),
                HasUniformStep = true,
                InFlightMs = settings.InFlightMs,
                // Nobody looks at its generations.
                SecondsToFirstGeneration = double.PositiveInfinity,
                SecondsPerGeneration = double.PositiveInfinity,
            };
            if (settings.MemoryBytes > 0)
                build.MemoryBytes = settings.MemoryBytes;
            ConvertedReader stored = null;
            long leftOut = 0;
            try
            {
                yield return JobStep.Of(ConvertCloud.Run(new[] { reader }, octree, build,
                    result => leftOut = result.Manifest.PointsLeftOut, progress));
                yield return JobStep.Of(PoolTask.Run(octree, () => ConvertedReader.Open(octree), opened => stored = opened,
                    unwanted => unwanted.DisposeUnread()));
                // Errors and losses name the source.
                stored.Info.Path = reader.Info.Path;
                yield return JobStep.Of(Run(stored, path, settings, result =>
                {
                    result.PointsRead += leftOut;
                    result.PointsLeftOut += leftOut;
                    done(result);
                }, progress));
            }
            finally
            {
                stored?.Dispose();
                if (Directory.Exists(octree))
                    FileChanges.BeginDelete(octree, _ => { });
            }
        }

        public void Dispose()
        {
            if (!m_state.IsCreated)
                return;
            m_state.Dispose();
            m_clips.Dispose();
            m_classes.Dispose();
            m_converted.Dispose();
            m_chosen.Dispose();
            m_noBuffers.Dispose();
        }

        static ExportFormat FormatOf(PointReader reader, string path, ExportSettings settings)
        {
            CheckClasses(reader, settings);
            var format = FormatOf(reader, path, settings.Attributes);
            if (reader.Info.UnexportableFacts is string facts)
                format.Losses.Add(new Loss(facts, reader.Info.Path, Path.GetExtension(path) + " has no place for them"));
            return format;
        }

        static ExportFormat FormatOf(PointReader reader, string path, string[] attributes)
        {
            return Path.GetExtension(path).ToLowerInvariant() switch
            {
                ".ply" => new PlyExport(reader, attributes),
                ".laz" when CopcExport.IsNamed(path) => new CopcExport((ConvertedReader)reader, attributes),
                ".laz" => new LazExport(reader, attributes, reader.PointCount),
                ".las" => (ExportFormat)new LasExport(reader, attributes, reader.PointCount),
                _ => throw new PointCloudException(FailureCode.Unsupported, path, -1,
                    "wanted a name that ends in .las, .laz, .copc.laz or .ply"),
            };
        }

        static void CheckClasses(PointReader reader, ExportSettings settings)
        {
            if (settings.Classes != null && !reader.Info.Schema.Has(AttributeNames.Classification))
                throw new PointCloudException(FailureCode.BadInput, reader.Info.Path, -1, "has no classes to choose from");
        }

        /// <summary>Coroutine: measures the bounds of the points if the format chooses a grid by them; converted clouds know
        /// theirs.</summary>
        IEnumerator<JobStep> SetBounds()
        {
            m_state.Value = ExportState.None;
            if (!m_format.NeedsBounds)
                yield break;
            var measured = ExportState.None;
            if (m_reader is ConvertedReader stored)
            {
                measured.MinStored = stored.Manifest.BoundsMin;
                measured.MaxStored = stored.Manifest.BoundsMax;
            }
            else
            {
                m_progress?.Begin("measure");
                var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
                if (m_settings.Classes != null)
                    names.Add(AttributeNames.Classification);
                if (m_settings.Filter != null)
                    names.AddRange(m_settings.Filter.Attributes);
                yield return JobStep.Of(Pass(m_wanted.Select(names.ToArray()), null));
                measured = m_state.Value;
                m_state.Value = ExportState.None;
            }
            m_format.SetBounds(measured);
        }

        IEnumerator<JobStep> Write(string path, Action<ExportResult> done)
        {
            using var buffers = new ExportBuffers(path, m_format, ExportRange.MaxPointsOf(m_ranges), Slices.MaxChains);
            yield return JobStep.Of(buffers.Write(m_format.MakeHeader(path, m_state.Value, 0, 0), false));
            yield return JobStep.Of(Pass(m_wanted, buffers));
            yield return JobStep.Of(buffers.Drain(m_filled));
            long chunksEnd = buffers.Bytes;
            yield return JobStep.Of(buffers.Write(m_format.Trailer(), false));
            long pointsEnd = buffers.Bytes;
            foreach (var (offset, bytes) in m_format.Tail)
                yield return JobStep.Of(CopyTail(buffers, offset, bytes));
            foreach (var bytes in m_format.TailBytes)
                yield return JobStep.Of(buffers.Write(bytes, false));
            var state = m_state.Value;
            yield return JobStep.Of(buffers.Write(m_format.MakeHeader(path, state, chunksEnd, pointsEnd), true));
            done(new ExportResult(m_format, state, buffers.Bytes));
        }

        IEnumerator<JobStep> CopyTail(ExportBuffers buffers, long offset, long bytes)
        {
            const int pieceBytes = 4 << 20;
            using var read = new StoreRead();
            for (long at = 0; at < bytes; at += pieceBytes)
            {
                string path = SourcePath.Full(m_reader.Info.Path);
                read.Begin(path, offset + at, Math.Min(pieceBytes, bytes - at), RemoteFile.Find(path));
                while (!read.IsFetched)
                    yield return default;
                yield return read.Done;
                read.Complete();
                yield return JobStep.Of(CloudFolderWriter.Await(buffers.Append(read.Bytes)));
            }
        }

        /// <summary>Goes over all ranges, several in flight, and appends their points one after another.</summary>
        /// <param name="buffers">Null to measure.</param>
        IEnumerator<JobStep> Pass(PointSchema wanted, ExportBuffers buffers)
        {
            int maxPoints = ExportRange.MaxPointsOf(m_ranges);
            var limit = SourceScan.LimitFor(m_reader, wanted, 0, SourceScan.MaxSlotBytes, 0, () => m_settings.InFlightMs);
            var idle = new Stack<Slot>();
            var all = new List<Slot>();
            var inFlight = new Queue<Slot>();
            var last = default(JobHandle);
            long pointsInFlight = 0, read = 0, filled = 0, bytes = 0;
            using var window = m_reader.WindowOf(0, m_ranges.Count, n => m_ranges[n].Range);
            try
            {
                for (int next = 0; next < m_ranges.Count || inFlight.Count > 0;)
                {
                    bool hasRoom = next < m_ranges.Count && (buffers == null || buffers.HasRoom(m_format.HasBufferPerNode
                        ? (m_ranges[next].Node + 1L) * m_format.BufferPoints
                        : filled + pointsInFlight + m_ranges[next].Range.Count));
                    if (hasRoom && inFlight.Count < limit.Value)
                    {
                        if (idle.Count == 0)
                        {
                            all.Add(new Slot(m_reader, wanted, maxPoints, m_format, m_settings.Filter));
                            idle.Push(all[all.Count - 1]);
                        }
                        while (window != null && !window.TryPrepareNext())
                            yield return default;
                        var slot = idle.Pop();
                        slot.Read.Fetched = window?.Take();
                        last = slot.Begin(m_ranges[next], JobOf(buffers), last);
                        pointsInFlight += m_ranges[next++].Range.Count;
                        inFlight.Enqueue(slot);
                        JobHandle.ScheduleBatchedJobs();
                        yield return default;
                        continue;
                    }
                    if (inFlight.Count > 0)
                    {
                        var slot = inFlight.Peek();
                        limit.BeginWait();
                        yield return slot.Done;
                        limit.EndWait(next < m_ranges.Count && hasRoom && last.IsCompleted);
                        filled = slot.Complete();
                        if (buffers != null && slot.Range.IsLastOfNode)
                            filled = buffers.EndNode(slot.Range.Node, filled);
                        pointsInFlight -= slot.Read.Range.Count;
                        read += slot.Read.Points.Count;
                        bytes += m_reader.BytesOfRange(slot.Read.Range);
                        idle.Push(inFlight.Dequeue());
                        m_progress?.Report((next - inFlight.Count) / (double)m_ranges.Count, read, bytes);
                    }
                    else if (buffers != null)
                        yield return buffers.OldestJobs;
                    buffers?.Advance(filled, inFlight.Count == 0 ? 1 : 0);
                    yield return default;
                }
            }
            finally
            {
                last.Complete();
                m_filled = filled;
                foreach (var slot in all)
                    slot.Dispose();
            }
        }

        MakeRecordsJob JobOf(ExportBuffers buffers) => new MakeRecordsJob
        {
            Converted = m_converted,
            Chosen = m_chosen,
            Clips = m_clips,
            Classes = m_classes,
            Position = m_format.Position,
            Buffers = buffers?.Pointers ?? m_noBuffers,
            BufferPoints = m_format.BufferPoints,
            RecordBytes = m_format.RecordBytes,
            ReturnMask = m_format.ReturnMask,
            MinPosition = double.NegativeInfinity,
            MaxPosition = double.PositiveInfinity,
            State = m_state,
        };

        sealed class Slot : IDisposable
        {
            readonly ExportFormat m_format;
            NativeArray<PointColumn> m_columns;
            NativeArray<FieldCopy> m_copies;
            NativeArray<FieldCopy> m_convertedCopies;
            NativeArray<ColumnConversion> m_conversions;
            readonly IFilterSlot m_filter;
            NativeReference<long> m_end = new NativeReference<long>(Allocator.Persistent);

            public Slot(PointReader reader, PointSchema wanted, int maxPoints, ExportFormat format, IPointFilter filter)
            {
                m_format = format;
                Read = reader.CreateRead(wanted, maxPoints, Allocator.Persistent);
                PlanCopies(out var same, out var changed, out var changes);
                m_copies = new NativeArray<FieldCopy>(same, Allocator.Persistent);
                m_convertedCopies = new NativeArray<FieldCopy>(changed, Allocator.Persistent);
                m_conversions = new NativeArray<ColumnConversion>(changes, Allocator.Persistent);
                m_columns = new NativeArray<PointColumn>(wanted.Count, Allocator.Persistent);
                for (int i = 0; i < wanted.Count; i++)
                    m_columns[i] = Read.Points.Column(i);
                m_filter = filter?.CreateSlot(Read.Points, reader.Info.Transform);
            }

            public BlockRead Read { get; }

            public ExportRange Range { get; private set; }

            public JobHandle Done { get; private set; }

            public JobHandle Begin(in ExportRange range, MakeRecordsJob job, JobHandle after)
            {
                Range = range;
                Read.Begin(range.Range);
                job.Columns = Read.Points.Bytes;
                job.Decoded = Read.Result;
                job.Positions = PositionColumns.Of(Read.Points);
                job.AllColumns = m_columns;
                job.Copies = m_copies;
                job.ConvertedCopies = m_convertedCopies;
                job.Conversions = m_conversions;
                job.Fraction = range.Fraction;
                job.End = m_end;
                m_format.Configure(range, ref job);
                int classification = Read.Points.Schema.IndexOf(AttributeNames.Classification);
                if (classification >= 0)
                    job.Classification = Read.Points.Column(classification);
                var decoded = Read.Decoded;
                if (m_filter != null && range.Range.Count > 0)
                {
                    decoded = m_filter.Schedule(Read.Result, range.Range, Read.FirstPoint, decoded);
                    job.Decoded = m_filter.Result;
                }
                Done = JobHandle.CombineDependencies(decoded, after);
                for (int first = 0; first < range.Range.Count; first += MakeRecordsJob.PointsPerSlice)
                {
                    job.First = first;
                    job.Count = Math.Min(MakeRecordsJob.PointsPerSlice, range.Range.Count - first);
                    Done = job.Schedule(Done);
                }
                return Done;
            }

            public long Complete()
            {
                Done.Complete();
                Read.Complete();
                return m_end.Value;
            }

            public void Dispose()
            {
                Done.Complete();
                m_filter?.Dispose();
                Read.Dispose();
                m_columns.Dispose();
                m_copies.Dispose();
                m_convertedCopies.Dispose();
                m_conversions.Dispose();
                m_end.Dispose();
            }

            /// <summary>Which columns go into records as they are, and which are converted first.</summary>
            void PlanCopies(out FieldCopy[] same, out FieldCopy[] changed, out ColumnConversion[] changes)
            {
                const int stride = 8 * MakeRecordsJob.PointsPerSlice;
                var batch = Read.Points;
                var fields = new List<PointField>();
                var columns = new List<PointColumn>();
                var changedFields = new List<PointField>();
                var changedColumns = new List<PointColumn>();
                var planned = new List<ColumnConversion>();
                for (int axis = 0; axis < 3; axis++)
                {
                    var field = m_format.Axes[axis];
                    bool isSame = m_format.Position.Kind == PositionKind.Copied;
                    (isSame ? fields : changedFields).Add(field);
                    (isSame ? columns : changedColumns).Add(isSame ? batch.Column(batch.Schema.IndexOf(field.Name))
                        : new PointColumn { OffsetBytes = axis * stride, Type = field.Type });
                }
                foreach (var column in m_format.Columns)
                {
                    // To measure, positions are enough.
                    int index = batch.Schema.IndexOf(column.From);
                    if (index < 0)
                        continue;
                    var from = batch.Column(index);
                    bool isSame = column.IsSame(from.Type);
                    var to = isSame ? from
                        : new PointColumn { OffsetBytes = (3 + planned.Count) * stride, Type = column.To.Type };
                    (isSame ? fields : changedFields).Add(column.To);
                    (isSame ? columns : changedColumns).Add(to);
                    if (!isSame)
                        planned.Add(new ColumnConversion
                        {
                            From = from,
                            To = to,
                            Scale = column.Scale,
                            Offset = column.Offset,
                            Max = column.Max,
                        });
                }
                same = FieldCopyPlan.Make(fields.ToArray(), columns.ToArray());
                changed = FieldCopyPlan.Make(changedFields.ToArray(), changedColumns.ToArray());
                changes = planned.ToArray();
            }
        }
    }
}
