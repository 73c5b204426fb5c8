using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Build
{
    /// <summary>What all stages of a build share: what the cloud is made from and into, how its points lie on the grid, and the
    /// memory and files that hold them meanwhile. It owns these, so it is disposed after the stages.</summary>
    internal sealed class BuildContext : IDisposable
    {
        public readonly IReadOnlyList<PointReader> Readers;
        public readonly ConvertSettings Settings;
        public readonly StageProgress Progress; // May be null.

        public readonly string Target;

        public readonly PointSchema Attributes;
        public readonly CloudFolderWriter Folder;

        public readonly SliceTimes SliceTimes;

        /// <param name="target">Null where nothing is written.</param>
        /// <exception cref="PointCloudException">The sources' attributes differ, or the target cannot be written.</exception>
        public BuildContext(IReadOnlyList<PointReader> readers, string target, ConvertSettings settings, StageProgress progress)
            : this(readers, AttributeChoice.Of(readers, settings.Attributes), target, settings, progress) { }

        BuildContext(IReadOnlyList<PointReader> readers, PointSchema attributes, string target, ConvertSettings settings,
            StageProgress progress)
        {
            Readers = readers;
            Settings = settings;
            Progress = progress;
            Target = target;
            Attributes = attributes;
            Folder = target == null ? null : new CloudFolderWriter(target);
            SliceTimes = new SliceTimes(Allocator.Persistent);
        }

        /// <summary>The same for a part of a cloud, whose grid and chunks are planned.</summary>
        /// <param name="readers">None where its points are in files.</param>
        /// <param name="points">At most; without the readers'.</param>
        public BuildContext(BuildPart part, IReadOnlyList<PointReader> readers, long points, string target,
            ConvertSettings settings, StageProgress progress) : this(readers, part.Attributes, target, settings, progress)
        {
            Part = part;
            CloudId = part.CloudId;
            var sources = new SourceToGrid[readers.Count];
            Grid = new GridChoice { Grid = part.Grid, RecordLayout = part.RecordLayout, Sources = sources };
            for (int i = 0; i < readers.Count; i++)
            {
                Grid.Sources[i] = GridChoice.OnGrid(readers[i].Info, part.Grid);
                points += readers[i].PointCount;
            }
            Points = points;
            Allot(MemoryPlan.For(Points, RecordLayout.StrideBytes, settings, part.PointsPerChunk));
        }

        public BuildPart Part { get; } // Null for a whole cloud.

        /// <summary>Takes the points of the part's own blocks since the last call; null unless it is read from sources.</summary>
        public Func<long> TakeOwnBlockPoints { get; set; }

        public long Points { get; private set; }
        public GridChoice Grid { get; private set; }
        public RecordLayout RecordLayout => Grid.RecordLayout;
        public MemoryPlan Plan { get; private set; }

        public NativeReference<RecordPagePool> Pool { get; private set; }

        /// <summary>Records that do not fit into memory, or all records of a long build; null if all stay in
        /// memory.</summary>
        public RecordFiles Files { get; private set; }

        public PartitionMap Map { get; set; } // The first partition. Setting it hands it over.

        public ulong CloudId { get; set; } // See CloudIdentity; known once there is a partition.

        public NodeSizes Sizes
        {
            get
            {
                var sizes = NodeSizes.Default;
                if (Settings.CellsLog2 > 0)
                    sizes.CellsLog2 = Settings.CellsLog2;
                if (Settings.TargetPointsPerLeaf > 0)
                    sizes.TargetPointsPerLeaf = Settings.TargetPointsPerLeaf;
                return sizes;
            }
        }

        public string SamplerName => Settings.Sampler.ToString().ToLowerInvariant();

        public double InFlightMs() => Settings.InFlightMs;

        public int MaxSlots(int slots) => Settings.Workers > 0 ? Math.Min(slots, Settings.Workers) : slots;

        /// <summary>Chooses the grid, and plans memory and files. The readers' blocks are known.</summary>
        public void Choose(IReadOnlyList<SampleStatistics> samples)
        {
            var infos = new List<SourceInfo>();
            foreach (var reader in Readers)
            {
                infos.Add(reader.Info);
                Points += reader.PointCount;
            }
            Grid = GridChoice.Choose(infos, samples, Attributes.BytesPerPoint, Settings.HasUniformStep);
            Allot(MemoryPlan.For(Points, RecordLayout.StrideBytes, Settings));
        }

        void Allot(MemoryPlan plan)
        {
            Plan = plan;
            if (Settings.ProcessBytes > 0 && Plan.UsesTemporaryFiles && Plan.MinMemoryBytes > Settings.MemoryBytes)
                throw PointCloudException.Wanted(FailureCode.Unsupported, Target, -1, "memory for a chunk of this cloud",
                    "at least " + ((Settings.ProcessBytes + Plan.MinMemoryBytes >> 20) + 1) + "MiB",
                    (Settings.ProcessBytes + Settings.MemoryBytes >> 20) + "MiB");
            Pool = new NativeReference<RecordPagePool>(
                new RecordPagePool(RecordLayout.StrideBytes, Points / RecordPages.RecordsPerPage), Allocator.Persistent);
            if (Plan.UsesTemporaryFiles)
                UseFiles();
        }

        public void UseFiles() => Files ??= new RecordFiles(Folder, RecordLayout.StrideBytes);

        /// <summary>The same if all are in memory, and the disk has room for all of them.</summary>
        public bool TryUseFiles()
        {
            long free = Folder.FreeBytes();
            if (Files == null && (free < 0 || free >= Points * RecordLayout.StrideBytes))
            {
                UseFiles();
                AddPartitionFiles();
            }
            return Files != null;
        }

        /// <exception cref="PointCloudException">The disk has no room for points that do not fit into memory.</exception>
        public void RequireRoom(long points)
        {
            long needed = points * RecordLayout.StrideBytes, free = Folder.FreeBytes();
            if (Files != null && free >= 0 && free < needed)
                throw new PointCloudException(FailureCode.DiskFull, Target, -1, string.Format(CultureInfo.InvariantCulture,
                    "the disk has too little room: wanted {0} bytes for the points that do not fit into memory, got {1}", needed,
                    free));
        }

        public void AddPartitionFiles()
        {
            while (Files != null && Files.FileCount < Map.Chunks.Length + 1)
                Files.Add();
        }

        public ChunkIndexer CreateIndexer(NativeStoreLayout store, CloudManifest manifest) =>
            new ChunkIndexer(RecordLayout, store, manifest.Root.Corner, manifest.CloudId, Settings.Sampler, Sizes);

        public IndexWorkspace CreateWorkspace(NativeStoreLayout store) => new IndexWorkspace(RecordLayout, store);

        public void Dispose()
        {
            Map?.Dispose();
            Files?.Dispose();
            SliceTimes.Dispose();
            if (Pool.IsCreated)
            {
                RecordPagePool.Of(Pool).FreeAll();
                Pool.Dispose();
                Pool = default;
            }
            if (Settings.KeepUnfinished)
                Folder?.Keep();
            Folder?.Dispose();
        }
    }

    /// <summary>What a plan fixes for one of the builds that make a cloud together: with it the bytes of a part are those that
    /// one build of everything would write.</summary>
    internal sealed class BuildPart
    {
        public ulong CloudId;
        public long Points; // By the headers, of the whole cloud.
        public long PointsPerChunk;

        public CloudGrid Grid;
        public RecordLayout RecordLayout;
        public PointSchema Attributes; // Those of the cloud, beside the position, and a divisor for each.
        public int[] Divisors;
        public GridCube CloudCube; // The plan's cube of the cloud. Points outside of it are set aside until all parts are built.
        public GridCube Cube; // The part's cube, half-open, and the base cells in it, in Morton order.
        public GridCube[] BaseCells;

        public BuildPart Clone() => (BuildPart)MemberwiseClone();

        public bool IsWhole => Cube.Corner == CloudCube.Corner && Cube.SideLog2 == CloudCube.SideLog2;

        /// <summary>A cube that holds all points of the cloud: the smallest one if the part knows all of them.</summary>
        public GridCube RootOf(in PointStatistics found)
        {
            if (!IsWhole)
                return Cube.ContainsAligned(CloudCube) ? Cube : CloudCube;
            var grown = RootCube.Grow(CloudCube, found.Min, found.Max);
            return grown.Length > 0 ? grown[grown.Length - 1] : CloudCube;
        }
    }

    internal static class AttributeChoice
    {
        /// <summary>The first source's attributes except its position. Every source must have the same ones.</summary>
        /// <param name="names">Names of the wanted ones; null for all.</param>
        /// <exception cref="PointCloudException">A source has no position, or lacks one of the attributes.</exception>
        public static PointSchema Of(IReadOnlyList<PointReader> readers, string[] names)
        {
            var chosen = new List<PointAttribute>();
            foreach (var attribute in readers[0].Info.Schema)
            {
                bool isPosition = attribute.Name == AttributeNames.X || attribute.Name == AttributeNames.Y ||
                    attribute.Name == AttributeNames.Z;
                if (!isPosition && (names == null || Array.IndexOf(names, attribute.Name) >= 0))
                    chosen.Add(attribute);
            }
            foreach (var reader in readers)
            {
                var schema = reader.Info.Schema;
                foreach (string axis in new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z })
                {
                    if (!schema.Has(axis))
                        throw new PointCloudException(FailureCode.Unsupported, reader.Info.Path, -1, "no " + axis);
                }
                foreach (var attribute in chosen)
                {
                    int column = schema.IndexOf(attribute.Name);
                    if (column < 0 || !schema[column].Equals(attribute))
                        throw PointCloudException.Wanted(FailureCode.Unsupported, reader.Info.Path, -1,
                            "an attribute of the first file", attribute, column < 0 ? "none" : schema[column].ToString());
                }
            }
            return new PointSchema(chosen);
        }
    }
}
