using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using FastPoints.Drawing;
using FastPoints.Reading;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Computes the normals of a converted cloud's points, and stores them in containers beside those of the points. Of
    /// what is there pages alone are written anew, under a new name, and cloud.json last: until then, also if it is stopped, the
    /// cloud is as it was.</summary>
    internal sealed class AddNormals : IDisposable
    {
        public const string Stage = "normals";

        static readonly string[] s_attributes = { AttributeNames.NormalX, AttributeNames.NormalY, AttributeNames.NormalZ };

        readonly CloudFolder m_folder;
        readonly string m_path;
        readonly FolderLock m_lock;
        readonly WriteQueue m_queue;
        SliceTimes m_slices;
        bool m_isDisposed;

        AddNormals(CloudFolder folder)
        {
            m_folder = folder;
            m_path = folder.FolderPath;
            string owner = FolderLock.TakeOrGetOwner(Path.Combine(m_path, CloudFolderWriter.LockName), out m_lock);
            if (owner != null)
                throw new PointCloudException(FailureCode.WriteFailed, m_path, -1, "is being written by " + owner);
            m_queue = new WriteQueue(() => m_lock.Renew(DateTime.UtcNow) ? null
                : new PointCloudException(FailureCode.WriteFailed, m_path, -1, "was taken over by another process"),
                FolderLock.RenewAfter);
            m_slices = new SliceTimes(Allocator.Persistent);
        }

        /// <summary>Coroutine.</summary>
        /// <param name="path">A finished cloud of several files on this machine.</param>
        /// <param name="settings">Null for defaults.</param>
        /// <param name="done">Receives its manifest.</param>
        /// <exception cref="PointCloudException">It is none, is damaged, or cannot be written.</exception>
        public static IEnumerator<JobStep> Run(string path, NormalSettings settings, Action<CloudManifest> done,
            StageProgress progress)
        {
            settings ??= new NormalSettings();
            CloudFolder folder = null;
            yield return JobStep.Of(PoolTask.Run(path, () => Open(path), opened => folder = opened,
                unwanted => unwanted.Dispose()));
            using (folder)
            using (var add = new AddNormals(folder))
            {
                add.DeleteOldVersions(folder.Manifest);
                var manifest = folder.Manifest.Clone();
                manifest.Generation++;
                manifest.NormalLayer = checked((ushort)(manifest.NormalLayer + 1));
                bool isPacked = HasSourceNormals(manifest);
                manifest.NormalOrientation = isPacked ? NormalOrientations.OfSource
                    : AreScannersKnown(manifest) ? NormalOrientations.Scanner
                    : IsOnTheEarth(manifest.Crs) ? NormalOrientations.Up : NormalOrientations.Viewer;
                using var cubes = new NormalCubes(folder, settings);
                using var normals = new NormalContainers(folder, cubes, manifest.NormalLayer, add.Write);
                progress?.Begin(Stage);
                yield return JobStep.Of(normals.LoadPages());
                yield return JobStep.Of(isPacked ? add.Pack(cubes, normals, progress)
                    : add.Estimate(cubes, normals, settings.Workers, progress));
                normals.CheckComplete();
                yield return JobStep.Of(NormalPages.Write(folder, manifest, normals, add.m_queue));
                yield return JobStep.Of(add.Finish(manifest));
                progress?.End();
                done?.Invoke(manifest);
            }
        }

        static CloudFolder Open(string path)
        {
            if (SourcePath.IsRemote(path))
                throw new PointCloudException(FailureCode.Unsupported, path, -1,
                    "wanted a cloud on this machine, got an address");
            var folder = CloudFolder.Open(path);
            if (!folder.IsUnfinished && !folder.Manifest.IsSingleFile)
                return folder;
            folder.Dispose();
            throw new PointCloudException(FailureCode.Unsupported, path, -1, "wanted a finished cloud of several files, got " +
                (folder.Manifest.IsSingleFile ? "one of a single file" : "one that is being built"));
        }

        public void Dispose()
        {
            if (m_isDisposed)
                return;
            m_isDisposed = true;
            m_queue.End();
            m_lock.Dispose();
            m_slices.Dispose();
        }

        static bool AreScannersKnown(CloudManifest manifest) => manifest.Scanners != null &&
            (manifest.Scanners.Length == 1 || manifest.Attributes.IndexOf(AttributeNames.PointSourceId) >= 0);

        static bool IsOnTheEarth(CloudCrs crs)
        {
            var text = new CoordinateSystem();
            var kind = CrsText.Read(crs.Wkt ?? crs.Name ?? "", text) ? text.Kind : CrsKind.Unknown;
            if (kind == CrsKind.Unknown)
                kind = EpsgTable.Find(crs.Epsg)?.Kind ?? CrsKind.Unknown;
            return kind == CrsKind.Projected || kind == CrsKind.Geographic ||
                kind == CrsKind.Unknown && (crs.Epsg != 0 || crs.GeoKeys != null);
        }

        /// <summary>Whether its files have normals, not only room for them.</summary>
        static bool HasSourceNormals(CloudManifest manifest)
        {
            bool isAny = false;
            foreach (string name in s_attributes)
            {
                int i = manifest.Attributes.IndexOf(name);
                if (i < 0)
                    return false;
                isAny |= manifest.Ranges[i].Min != 0 || manifest.Ranges[i].Max != 0;
            }
            return isAny;
        }

        /// <summary>Takes the normals that the files have.</summary>
        IEnumerator<JobStep> Pack(NormalCubes cubes, NormalContainers normals, StageProgress progress)
        {
            var schema = LoadNodes.SchemaFor(m_folder, s_attributes);
            foreach (var _ in cubes.ChooseBatches())
            {
                using var batch = new PointBatch(schema, cubes.PointCountOrThrow, Allocator.Persistent);
                using var found = new NativeArray<ushort>(batch.Capacity, Allocator.Persistent);
                yield return JobStep.Of(LoadNodes.Run(m_folder, cubes, batch, null));
                var job = PackSourceNormalsJob.Of(batch, s_attributes, found);
                yield return JobStep.Of(Slices.Run(0, batch.Count, PackSourceNormalsJob.PointsPerSlice, job.Schedule));
                yield return JobStep.Of(normals.AppendNormals(found));
                progress?.Report(normals.Points / (double)m_folder.Manifest.Points, normals.Points, normals.Bytes);
            }
        }

        IEnumerator<JobStep> Estimate(NormalCubes cubes, NormalContainers normals, Func<int> workers, StageProgress progress)
        {
            var schema = LoadNodes.SchemaFor(m_folder, AttributeNames.PointSourceId);
            var manifest = m_folder.Manifest;
            var toGeo = manifest.Grid.TransformFromCorner(manifest.Root.Corner);
            using var scanners = new NativeArray<double3>(!AreScannersKnown(manifest) ? Array.Empty<double3>()
                : Array.ConvertAll(manifest.Scanners, at => (at - toGeo.Offset) / toGeo.Scale), Allocator.Persistent);
            foreach (var cube in cubes.Cubes())
            {
                var region = cubes.Choose(cube);
                using var batch = new PointBatch(schema, Math.Max(1, cubes.PointCountOrThrow), Allocator.Persistent);
                using var found = new NativeArray<ushort>(batch.Capacity, Allocator.Persistent);
                Fill(found);
                yield return JobStep.Of(LoadNodes.Run(m_folder, cubes, batch, null));
                yield return JobStep.Of(NormalEstimator.Run(batch, region, found, m_slices, workers()));
                if (scanners.Length > 0)
                {
                    var job = OrientNormalsJob.Of(batch, scanners, region.StepMetres, found);
                    yield return JobStep.Of(Slices.Run(0, batch.Count, OrientNormalsJob.PointsPerSlice, job.Schedule));
                }
                yield return JobStep.Of(normals.AppendNormals(found));
                progress?.Report(normals.Points / (double)manifest.Points, normals.Points, normals.Bytes);
            }
        }

        static unsafe void Fill(NativeArray<ushort> found) =>
            new Span<ushort>(found.GetUnsafePtr(), found.Length).Fill(OctahedralNormal.Unset);

        WriteTicket Write(string name, NativeArray<byte> bytes)
        {
            string path = Path.Combine(m_path, name.Replace('/', Path.DirectorySeparatorChar));
            m_queue.Run(path, () => Directory.CreateDirectory(Path.GetDirectoryName(path)));
            return m_queue.Write(path, bytes);
        }

        /// <summary>Coroutine: the cloud has its normals once cloud.json is replaced; streams close its files for that.</summary>
        IEnumerator<JobStep> Finish(CloudManifest manifest)
        {
            // What was written is read once before it counts.
            using (var written = CloudFolder.Open(m_path, manifest))
                foreach (var _ in written.EachTable())
                    yield return default;
            FolderReleases.Release(m_path);
            try
            {
                while (!FolderReleases.HasReleased)
                    yield return default;
                using var text = new NativeArray<byte>(new UTF8Encoding(false).GetBytes(manifest.ToJson()), Allocator.Persistent);
                yield return JobStep.Of(CloudFolderWriter.Await(
                    m_queue.Write(Path.Combine(m_path, StoreFormat.ManifestName), text)));
                DeleteOldVersions(manifest);
                yield return JobStep.Of(CloudFolderWriter.Await(m_queue.Run(m_path, () => { })));
            }
            finally
            {
                FolderReleases.Reacquire(m_path);
            }
        }

        void DeleteOldVersions(CloudManifest manifest) => m_queue.Run(m_path, () =>
        {
            foreach (string file in Directory.GetFiles(m_path, "hierarchy*.bin*"))
                if (Path.GetFileName(file) != manifest.HierarchyName)
                    FileChanges.TryDelete(file, m_queue.ShouldRetry);
            string layers = Path.Combine(m_path, StoreFormat.LayerFolderName);
            foreach (string layer in Directory.Exists(layers) ? Directory.GetDirectories(layers) : Array.Empty<string>())
                if (Path.GetFileName(layer) != NumberText.Of((long)manifest.NormalLayer))
                    FileChanges.TryDelete(layer, m_queue.ShouldRetry);
        });
    }

    // Where computed normals point: values of the manifest.
    internal static class NormalOrientations
    {
        public const string Up = "up"; // Points in a system of the earth's surface were measured from above, or are shown as if.
        public const string Viewer = "viewer"; // Whoever shows them turns them to the viewer.
        public const string Scanner = "scanner"; // To the scanner of each point.
        public const string OfSource = "source"; // They are those of the files.
    }

    /// <summary>A slice of packing normals that points have as attributes; those that are no direction become none.</summary>
    [BurstCompile]
    internal unsafe struct PackSourceNormalsJob : IJob
    {
        public const int PointsPerSlice = 50_000; // A slice takes about 2 ms.

        public int First;
        public int End;
        [ReadOnly] public NativeArray<byte> Batch;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;
        public double3 Scale;
        public double3 Offset;
        public NativeArray<ushort> Normals; // Out, by point.

        public static PackSourceNormalsJob Of(PointBatch batch, string[] names, NativeArray<ushort> normals)
        {
            int x = batch.Schema.IndexOf(names[0]), y = batch.Schema.IndexOf(names[1]), z = batch.Schema.IndexOf(names[2]);
            PointAttribute ofX = batch.Schema[x], ofY = batch.Schema[y], ofZ = batch.Schema[z];
            return new PackSourceNormalsJob
            {
                Batch = batch.Bytes,
                X = batch.Column(x),
                Y = batch.Column(y),
                Z = batch.Column(z),
                Scale = new double3(ofX.Scale, ofY.Scale, ofZ.Scale),
                Offset = new double3(ofX.Offset, ofY.Offset, ofZ.Offset),
                Normals = normals,
            };
        }

        public JobHandle Schedule(int first, int end, JobHandle after)
        {
            (First, End) = (first, end);
            return this.Schedule(after);
        }

        public void Execute()
        {
            var bytes = (byte*)Batch.GetUnsafeReadOnlyPtr();
            for (int i = First; i < End; i++)
            {
                var n = Offset + Scale * new double3(ColumnValues.ToDouble(bytes + X.OffsetBytes, X.Type, i),
                    ColumnValues.ToDouble(bytes + Y.OffsetBytes, Y.Type, i),
                    ColumnValues.ToDouble(bytes + Z.OffsetBytes, Z.Type, i));
                // To a length that squares to neither 0 nor infinity.
                n /= math.cmax(math.abs(n));
                Normals[i] = math.all(math.isfinite(n)) ? OctahedralNormal.Encode((float3)n) : OctahedralNormal.None;
            }
        }
    }

    [BurstCompile]
    internal unsafe struct OrientNormalsJob : IJob
    {
        public const int PointsPerSlice = 50_000; // A slice takes about 2 ms.

        public int First;
        public int End;
        [ReadOnly] public NativeArray<byte> Batch;
        public PositionColumns Positions;
        public PointColumn Scan; // The number of a point's scan, from 1; not read if there is one.
        [ReadOnly] public NativeArray<double3> Scanners; // By scan: in the batch's coordinates.

        public double3 MetresPerStep;
        public NativeArray<ushort> Normals; // In, out.

        public static OrientNormalsJob Of(PointBatch batch, NativeArray<double3> scanners, double3 metres,
            NativeArray<ushort> normals) => new OrientNormalsJob
            {
                Batch = batch.Bytes,
                Positions = PositionColumns.Of(batch),
                Scan = scanners.Length > 1 ? batch.Column(batch.Schema.IndexOf(AttributeNames.PointSourceId)) : default,
                Scanners = scanners,
                MetresPerStep = metres,
                Normals = normals,
            };

        public JobHandle Schedule(int first, int end, JobHandle after)
        {
            (First, End) = (first, end);
            return this.Schedule(after);
        }

        public void Execute()
        {
            var bytes = (byte*)Batch.GetUnsafeReadOnlyPtr();
            for (int i = First; i < End; i++)
            {
                ushort normal = Normals[i];
                if (normal == OctahedralNormal.None || normal == OctahedralNormal.Unset)
                    continue;
                double scan = Scanners.Length == 1 ? 1 : ColumnValues.ToDouble(bytes + Scan.OffsetBytes, Scan.Type, i);
                if (!(scan >= 1 && scan <= Scanners.Length))
                    continue;
                var p = new double3(*(double*)Positions.X.At(bytes, i), *(double*)Positions.Y.At(bytes, i),
                    *(double*)Positions.Z.At(bytes, i));
                if (math.dot((Scanners[(int)scan - 1] - p) * MetresPerStep, OctahedralNormal.Decode(normal)) < 0)
                    Normals[i] = OctahedralNormal.Opposite(normal);
            }
        }
    }
}
