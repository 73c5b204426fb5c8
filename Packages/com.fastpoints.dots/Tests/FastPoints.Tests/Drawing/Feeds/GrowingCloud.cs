using System;
using System.IO;
using FastPoints.Build;
using FastPoints.Drawing;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    /// <summary>A scan that is a file at first, then a build in progress, then a converted cloud; and readers that know it, until
    /// this is disposed.</summary>
    sealed class GrowingCloud : IDisposable
    {
        public const int Points = 150_000;
        public const int PreviewPoints = 50_000;

        readonly TemporaryFolder m_scratch = new TemporaryFolder();
        readonly int3[] m_positions = new int3[Points];
        CoroutineStack m_build;

        public GrowingCloud()
        {
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < Points; i++)
                m_positions[i] = new int3(random.NextInt2(20000), random.NextInt(100));
            Folder = m_scratch.File("cloud" + StoreFormat.FolderExtension);
            Source = m_scratch.File("scan");
            CloudFeeds.Register(paths => new SourceFeed(Open(), PreviewPoints));
        }

        public string Folder { get; }
        public string Manifest => Path.Combine(Folder + StoreFormat.UnfinishedSuffix, StoreFormat.ManifestName);
        public string Source { get; }
        public bool IsBuilt { get; private set; }

        MemoryReader Open()
        {
            var centimetres = new PositionTransform { Scale = 0.01, Offset = StreamedTestCloud.OriginGeo };
            return MemoryReader.Of(m_positions, centimetres, 5000);
        }

        public void Build()
        {
            m_build ??= new CoroutineStack(ConvertCloud.Run(new[] { Open() }, Folder, new ConvertSettings
            {
                PointsPerChunk = 20_000,
                SecondsToFirstGeneration = 0,
                SecondsPerGeneration = 0,
            }, r => { }, null));
            if (IsBuilt)
                return;
            IsBuilt = !m_build.MoveNext();
            if (!IsBuilt)
                m_build.Current.Complete();
        }

        public void Cancel()
        {
            m_build.Dispose();
            m_build = null;
        }

        public void Dispose()
        {
            m_build?.Dispose();
            CloudFeeds.Register(null);
            m_scratch.Dispose();
        }
    }
}
