using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using FastPoints.Build;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Store;
using FastPoints.Streaming;
using FastPoints.Tests.Nodes;
using NUnit.Framework;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    sealed class StreamedTestCloud : IDisposable
    {
        const int MaxFrames = 2_000_000; // A read that never ends must not hang the tests.

        public const int WidthPx = 640;
        public const int HeightPx = 360;
        public static readonly double3 OriginGeo = new double3(690_000, 5_330_000, 500);

        readonly TemporaryFolder m_scratch = new TemporaryFolder();

        public StreamedTestCloud(int points = 120_000, long pointsPerChunk = 6000, uint seed = 7)
            : this(pointsPerChunk, Hills(points, seed)) { }

        public StreamedTestCloud(long pointsPerChunk, params PointReader[] readers)
        {
            Path = m_scratch.File("cloud" + StoreFormat.FolderExtension);
            Convert(pointsPerChunk, readers);
        }

        public void ConvertAgain(int points) => Convert(6000, new PointReader[] { Hills(points, 8) });

        void Convert(long pointsPerChunk, PointReader[] readers)
        {
            JobCoroutine.RunToEnd(ConvertCloud.Run(readers, Path,
                new ConvertSettings { PointsPerChunk = pointsPerChunk, CellsLog2 = 4, TargetPointsPerLeaf = 500 },
                r => { }, null));
        }

        public string Path { get; }

        public string[] ChunkFiles => Directory.GetFiles(System.IO.Path.Combine(Path, StoreFormat.ChunkFolderName));

        public FolderSource Open(params string[] planes) =>
            new FolderSource(CloudFolder.Open(Path), planes.Length > 0 ? planes : new[] { StoreLayout.ColorName });

        static MemoryReader Hills(int points, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var positions = new int3[points];
            for (int i = 0; i < points; i++)
            {
                var at = random.NextInt2(20000);
                positions[i] = new int3(at, (int)(800 * math.sin(at.x * 0.0007) * math.cos(at.y * 0.0009)) + random.NextInt(20));
            }
            var centimetres = new PositionTransform { Scale = new double3(0.01, 0.01, 0.01), Offset = OriginGeo };
            return MemoryReader.Of(positions, centimetres, 5000);
        }

        public static CloudPlacement Geo(NodeSource source) => CloudPlacement.Geo(source.Grid, source.Root);

        public int Add(StreamContext stream, double3 moved = default)
        {
            var source = Open();
            var placement = Geo(source);
            placement.OriginWorld += moved;
            return stream.Add(source, placement);
        }

        public static List<string> Failures(StreamContext stream)
        {
            var failures = new List<string>();
            while (stream.TryTakeFailure(out var failure))
                failures.Add(failure.ToString());
            return failures;
        }

        public static LodSettings Selection
        {
            get
            {
                var settings = LodSettings.Default;
                settings.MinScreenErrorPx = 0.1f;
                return settings;
            }
        }

        public static StreamContext Stream(long limitBytes = 64 << 20, int bankBytes = 1 << 20)
        {
            var stream = new StreamContext(new MemoryNodePool(limitBytes, bankBytes));
            stream.Settings.Selection = Selection;
            stream.Settings.FramesToRetry = 3;
            return stream;
        }

        public static Camera Near(double x, double y, double heading)
        {
            var eye = OriginGeo + new double3(x, y, 12);
            var forward = new double3(math.cos(heading), math.sin(heading), -0.4);
            return Camera.Perspective(eye, eye + forward, new double3(0, 0, 1), 60);
        }

        public static Camera Overview() => Camera.Perspective(OriginGeo + new double3(100, -160, 180),
            OriginGeo + new double3(100, 100, 0), new double3(0, 0, 1), 60);

        public static FrameStats Frame(StreamContext stream, Camera camera) =>
            Frame(stream, camera.ToStreamView(WidthPx, HeightPx));

        public static FrameStats Frame(StreamContext stream, StreamView view)
        {
            using var views = new NativeArray<StreamView>(1, Allocator.Temp) { [0] = view };
            return FrameStep.Run(stream, views);
        }

        public static FrameStats Settle(StreamContext stream, Camera camera) =>
            Settle(stream, camera.ToStreamView(WidthPx, HeightPx));

        public static FrameStats Settle(StreamContext stream, StreamView view)
        {
            for (int frame = 0; frame < MaxFrames; frame++)
            {
                var stats = Frame(stream, view);
                if (stats.IsSettled)
                    return stats;
                Thread.Yield();
            }
            Assert.Fail("streaming did not come to rest");
            return default;
        }

        public static FrameStats Rest(StreamContext stream, Camera camera)
        {
            int quiet = 0;
            for (int frame = 0; frame < MaxFrames; frame++)
            {
                var stats = Frame(stream, camera);
                quiet = stats.ReadsInFlight == 0 && stats.RequestedNodes == 0 && stats.UploadedNodes == 0 ? quiet + 1 : 0;
                if (quiet > 10)
                    return stats;
                Thread.Yield();
            }
            Assert.Fail("streaming did not come to rest");
            return default;
        }

        public void Dispose() => m_scratch.Dispose();

        internal static void RunJobsOfAFrame(StreamContext stream, NativeList<SelectedNode> wanted)
        {
            var selector = stream.Selector;
            FrameStep.Touch(stream);
            for (int i = 0; i < 2; i++)
                new ListWantedJob
                {
                    Clouds = stream.CloudPages,
                    Nodes = i == 0 ? selector.Selected : selector.Prefetched,
                    Frame = selector.Frame,
                    Wanted = wanted,
                }.Run();
            new ListDrawnJob
            {
                Clouds = stream.CloudPages,
                Selected = selector.Selected,
                Nodes = stream.Cache.Nodes,
                Frame = stream.Selector.Frame,
                FadeStep = 1,
                Drawn = stream.Drawn,
                LastDrawn = stream.LastDrawn,
                DrawnOfSelected = stream.DrawnOfSelected,
                Totals = stream.DrawnTotals,
            }.Run();
        }
    }
}
