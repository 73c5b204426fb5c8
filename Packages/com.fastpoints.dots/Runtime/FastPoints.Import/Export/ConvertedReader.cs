using System;
using System.Collections.Generic;
using FastPoints.Build;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Export
{
    /// <summary>A converted cloud as a source, as it is stored or as edited: positions are in grid steps, a block is a node with
    /// its inlined leaves, in the order of the files. Counts are of what is stored.</summary>
    internal sealed class ConvertedReader : PointReader
    {
        readonly CloudFolder m_folder;

        readonly List<NodeTable> m_tables = new List<NodeTable>();
        readonly List<string> m_paths = new List<string>();
        readonly List<ConvertedBlock> m_blocks = new List<ConvertedBlock>();
        int m_maxPoints = 1;
        int m_maxPlaneBlocks;

        // On a disk, what lies between two planes is read along up to this: another read would take longer.
        const int MaxGapBytes = 64 << 10;

        ConvertedReader(CloudFolder folder) => m_folder = folder;

        void Load()
        {
            var folder = m_folder;
            m_tables.Add(folder.Root);
            m_paths.Add(SourcePath.Full(folder.PlanesPathOf(0)));
            for (int page = 1; page < folder.PageCount; page++)
            {
                folder.FetchFrom(page);
                m_tables.Add(folder.LoadPage(page));
                m_paths.Add(SourcePath.Full(folder.PlanesPathOf(page)));
            }
            long first = 0;
            for (int page = 0; page < m_tables.Count; page++)
            {
                int begin = m_blocks.Count;
                var blockOfNode = new int[m_tables[page].Nodes.Length];
                for (int n = 0; n < blockOfNode.Length; n++)
                {
                    var node = m_tables[page].Nodes[n];
                    bool isInlined = node.PlaneNode != n;
                    m_maxPlaneBlocks = Math.Max(m_maxPlaneBlocks, node.PlaneBlocks);
                    blockOfNode[n] = isInlined ? blockOfNode[node.PlaneNode] : m_blocks.Count;
                    if (!isInlined)
                        m_blocks.Add(new ConvertedBlock { Page = page, Node = n, OwnPoints = node.PointCount });
                    var block = m_blocks[blockOfNode[n]];
                    block.Points += node.PointCount;
                    m_blocks[blockOfNode[n]] = block;
                }
                for (int b = begin; b < m_blocks.Count; b++)
                {
                    var block = m_blocks[b];
                    block.FirstPoint = first;
                    m_blocks[b] = block;
                    first += block.Points;
                    m_maxPoints = Math.Max(m_maxPoints, block.Points);
                }
            }
            Info = Describe(folder, first);
            StoredFacts.AddTo(Info, folder);
        }

        /// <exception cref="PointCloudException">It is no cloud, is still being built, or is damaged.</exception>
        public static ConvertedReader Open(string path) => Opened(new ConvertedReader(CloudFolder.Open(path)), reader =>
        {
            if (reader.Manifest.IsBuilding)
                throw new PointCloudException(FailureCode.Unsupported, path, -1, "this cloud is still being built");
            reader.Load();
        });

        /// <summary>The same, with its edits.</summary>
        /// <param name="added">One more, after these; may be null.</param>
        public static ConvertedReader OpenEdited(string path, EditOperation added = null) =>
            Opened(Open(path), reader => reader.Edits = EditPlan.Of(path, reader.Manifest, added));

        public EditPlan Edits { get; private set; } // Null as stored.

        internal override ulong FilterHash => Edits?.Hash ?? 0;

        public CloudManifest Manifest => m_folder.Manifest;

        public string RecordsPath => SourcePath.Combine(m_folder.FolderPath, StoreFormat.RecordsName);

        public override int BlockCount => m_blocks.Count;

        public override int MaxPointsPerBlock => m_maxPoints;

        public override long FirstPointOfBlock(int block) => m_blocks[block].FirstPoint;

        public override int PointsInBlock(int block) => m_blocks[block].Points;

        /// <summary>Points of the node itself, which come before those of its inlined leaves.</summary>
        public int OwnPointsOf(int block) => m_blocks[block].OwnPoints;

        /// <summary>0 for the root. Inlined leaves are a level below.</summary>
        public int LevelOf(int block) => Manifest.Root.SideLog2 - NodeOf(block).SideLog2;

        /// <summary>The node's cube, which holds its inlined leaves too.</summary>
        public BoundsGeo CubeOf(int block)
        {
            var cube = NodeOf(block).Cube;
            var end = cube.Corner + new Grid3(cube.Side, cube.Side, cube.Side);
            return new BoundsGeo(Manifest.Grid.ToGeo(cube.Corner), Manifest.Grid.ToGeo(end));
        }

        public override string FileOfBlock(int block, out long byteOffset)
        {
            byteOffset = RangeOf(block, StoreLayout.PositionPlane).OffsetBytes;
            return m_paths[m_blocks[block].Page];
        }

        PlaneRange RangeOf(int block, int plane)
        {
            var table = m_tables[m_blocks[block].Page];
            return table.PlaneRanges[m_blocks[block].Node * table.PlaneCount + plane];
        }

        public override long BytesOfRange(BlockRange range) => (long)range.Count * Info.Schema.BytesPerPoint / 2;

        internal override void ListPieces(BlockRange range, List<FilePiece> pieces)
        {
            int first = pieces.Count, page = m_blocks[range.Block].Page;
            for (int p = 0; p < m_folder.Layout.Planes.Count; p++)
            {
                if (!m_folder.Layout.Planes[p].IsSource)
                    continue;
                var plane = RangeOf(range.Block, p);
                var last = pieces.Count > first ? pieces[pieces.Count - 1] : default;
                if (pieces.Count == first || last.OffsetBytes + last.LengthBytes != plane.OffsetBytes)
                    pieces.Add(last = new FilePiece
                    {
                        Path = m_paths[page],
                        Remote = m_folder.PlanesRemoteOf(page),
                        OffsetBytes = plane.OffsetBytes,
                    });
                last.LengthBytes = plane.OffsetBytes + plane.LengthBytes - last.OffsetBytes;
                pieces[pieces.Count - 1] = last;
            }
        }

        public override BlockRead CreateRead(PointSchema wanted, int capacity, Allocator allocator) =>
            new ConvertedRead(this, wanted, capacity, allocator);

        public override void DisposeUnread()
        {
            // The first table is the folder's.
            for (int page = 1; page < m_tables.Count; page++)
                m_tables[page].Dispose();
            m_tables.Clear();
            m_folder.Dispose();
        }

        public NodeRecord NodeOf(int block) => m_tables[m_blocks[block].Page].Nodes[m_blocks[block].Node];

        static SourceInfo Describe(CloudFolder folder, long points)
        {
            var manifest = folder.Manifest;
            var attributes = new List<PointAttribute>();
            foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                attributes.Add(new PointAttribute(axis, AttributeType.Int64));
            attributes.AddRange(manifest.Attributes);
            return new SourceInfo
            {
                Path = folder.FolderPath,
                HeadHash = manifest.CloudId,
                Format = "FastPoints",
                Version = NumberText.Of((long)StoreFormat.Version),
                PointsClaimed = (ulong)manifest.Points,
                PointsReadable = points,
                HasBoundsClaimed = manifest.Points > 0,
                BoundsClaimed = manifest.BoundsGeo,
                Transform = new PositionTransform { Scale = manifest.Grid.Step, Offset = manifest.Grid.Origin },
                Schema = new PointSchema(attributes),
                Crs = new CoordinateSystem
                {
                    Name = manifest.CrsName,
                    Wkt = manifest.CrsWkt,
                    Epsg = manifest.CrsEpsg,
                    VerticalEpsg = manifest.CrsVerticalEpsg,
                    MetresPerUnit = manifest.MetresPerUnit,
                    VerticalMetresPerUnit = manifest.VerticalMetresPerUnit,
                    GeoKeys = manifest.CrsGeoKeys,
                },
                GpsTime = manifest.GpsTime,
            };
        }

        struct ConvertedBlock
        {
            public int Page;
            public int Node;
            public int OwnPoints;
            public int Points;
            public long FirstPoint;
        }

        sealed class ConvertedRead : OwningBlockRead
        {
            readonly ConvertedReader m_reader;
            readonly List<int> m_planes = new List<int> { StoreLayout.PositionPlane };
            NativeArray<PlaneShape> m_shapes;
            NativeArray<PlaneRange> m_ranges;
            NativeArray<long> m_planeOffsets;
            NativeArray<PlaneColumnTarget> m_targets;
            readonly EditSlot m_edits;
            GatherEditedJob m_gather;

            public ConvertedRead(ConvertedReader reader, PointSchema wanted, int capacity, Allocator allocator)
                : base(reader, wanted, capacity, allocator)
            {
                m_reader = reader;
                var layout = reader.m_folder.Layout;
                var targets = new List<PlaneColumnTarget>();
                for (int axis = 0; axis < 3; axis++)
                    AddTarget(targets, 0, axis, new StoredColumn { Type = AttributeType.Int64, Divisor = 1 },
                        reader.Info.Schema[axis].Name);
                for (int p = 1; p < layout.Planes.Count; p++)
                {
                    int before = targets.Count;
                    var plane = layout.Planes[p];
                    for (int c = 0; c < plane.ColumnCount && plane.IsSource; c++)
                        AddTarget(targets, m_planes.Count, c, layout.Columns[plane.FirstColumn + c],
                            layout.Attributes[layout.AttributeOfColumn[plane.FirstColumn + c]].Name);
                    if (targets.Count > before || plane.IsSource && NamesAny(reader.Edits, plane))
                        m_planes.Add(p);
                }
                OwnFile(0, allocator, m_planes.Count);
                m_targets = Own(new NativeArray<PlaneColumnTarget>(targets.ToArray(), allocator));
                m_shapes = Own(new NativeArray<PlaneShape>(m_planes.Count, allocator));
                m_ranges = Own(new NativeArray<PlaneRange>(m_planes.Count, allocator));
                m_planeOffsets = Own(new NativeArray<long>(m_planes.Count, allocator));
                if (reader.Edits == null)
                    return;
                m_edits = Own(new EditSlot(reader.Edits, layout, m_planes, reader.m_maxPlaneBlocks));
                var all = new PointColumn[Points.Schema.Count];
                var from = new List<PointColumn>();
                var to = new List<PointColumn>();
                for (int c = 0; c < all.Length; c++)
                {
                    all[c] = Points.Column(c);
                    int changed = m_edits.Values.Schema.IndexOf(Points.Schema[c].Name);
                    if (changed < 0)
                        continue;
                    from.Add(m_edits.Values.Column(changed));
                    to.Add(all[c]);
                }
                m_gather = new GatherEditedJob
                {
                    Columns = Points.Bytes,
                    AllColumns = Own(new NativeArray<PointColumn>(all, allocator)),
                    Edited = m_edits.EditedBlocks,
                    Values = m_edits.Values.Bytes,
                    From = Own(new NativeArray<PointColumn>(from.ToArray(), allocator)),
                    To = Own(new NativeArray<PointColumn>(to.ToArray(), allocator)),
                    Chosen = Own(new NativeArray<int>(capacity, allocator)),
                };
            }

            bool NamesAny(EditPlan edits, StoreLayout.Plane plane)
            {
                bool isNamed = false;
                for (int c = plane.FirstColumn; c < plane.FirstColumn + plane.ColumnCount && edits != null; c++)
                    isNamed |= edits.Schema.Has(m_reader.m_folder.Layout.NameOfColumn(plane, c));
                return isNamed;
            }

            void AddTarget(List<PlaneColumnTarget> targets, int plane, int column, StoredColumn stored, string name)
            {
                int index = Points.Schema.IndexOf(name);
                if (index >= 0)
                    targets.Add(new PlaneColumnTarget
                    {
                        Plane = plane,
                        Column = column,
                        Stored = stored,
                        To = Points.Column(index),
                    });
            }

            protected override JobHandle Schedule(BlockRange range)
            {
                var block = m_reader.m_blocks[range.Block];
                var node = m_reader.NodeOf(range.Block);
                for (int p = 0; p < m_planes.Count; p++)
                {
                    m_ranges[p] = m_reader.RangeOf(range.Block, m_planes[p]);
                    m_shapes[p] = m_reader.m_folder.Layout.ShapeOf(m_planes[p], node.IsWide);
                }
                int commands = LayOutInBuffer();
                var decoded = new DecodeConvertedJob
                {
                    File = FileRead.Buffer,
                    Ranges = m_ranges,
                    PlaneOffsets = m_planeOffsets,
                    Shapes = m_shapes,
                    Targets = m_targets,
                    BlockCount = node.PlaneBlocks,
                    Corner = node.Corner,
                    First = range.First,
                    Count = range.Count,
                    Columns = Points.Bytes,
                    Result = Result,
                }.Schedule(DependencyOf(FileRead.Begin(m_reader.m_paths[block.Page], commands)));
                return m_edits == null ? decoded : ScheduleEdits(range, node, decoded);
            }

            JobHandle ScheduleEdits(BlockRange range, in NodeRecord node, JobHandle decoded)
            {
                var job = m_gather;
                job.File = FileRead.Buffer;
                job.PlaneOffset = m_planeOffsets[0];
                job.Shape = m_shapes[0];
                job.BlockCount = node.PlaneBlocks;
                job.First = range.First;
                job.Count = range.Count;
                job.Result = Result;
                return job.Schedule(m_edits.Schedule(new EditNodeJob
                {
                    File = FileRead.Buffer,
                    Planes = m_ranges,
                    PlaneOffsets = m_planeOffsets,
                    PlaneShapes = m_shapes,
                    Corner = node.Corner,
                    BlockCount = node.PlaneBlocks,
                }, decoded));
            }

            // Planes that lie together are one segment; of a remote file, segments are parts of what ListPieces names.
            unsafe int LayOutInBuffer()
            {
                var commands = FileRead.Commands;
                int count = 0;
                long bytes = 0, end = 0, maxGap = m_reader.m_folder.RemoteOfTable(0) != null ? 0 : MaxGapBytes;
                for (int p = 0; p < m_planes.Count; p++)
                {
                    var plane = m_ranges[p];
                    if (count == 0 || plane.OffsetBytes < end || plane.OffsetBytes > end + maxGap)
                        commands[count++] = new ReadCommand { Offset = end = plane.OffsetBytes };
                    m_planeOffsets[p] = bytes + plane.OffsetBytes - end;
                    bytes = m_planeOffsets[p] + plane.LengthBytes;
                    end = plane.OffsetBytes + plane.LengthBytes;
                    var command = commands[count - 1];
                    command.Size = end - command.Offset;
                    commands[count - 1] = command;
                }
                FileRead.Reserve(bytes);
                var to = (byte*)FileRead.Buffer.GetUnsafePtr();
                for (int i = 0; i < count; i++)
                {
                    var command = commands[i];
                    command.Buffer = to;
                    to += command.Size;
                    commands[i] = command;
                }
                return count;
            }

            protected override void EndRead()
            {
                FileRead.End();
                if (Result.Value.Error != 0)
                    throw new PointCloudException(FailureCode.BadInput, m_reader.FileOfBlock(Range.Block, out _),
                        Result.Value.ErrorOffset, "the node's data is damaged: " +
                            StoreFile.HashProblem(m_ranges[Result.Value.Error - 1].Hash, Result.Value.ActualHash));
                m_edits?.Count();
            }

            protected override void Cancel() => FileRead.Cancel();
        }
    }
}
