using System;
using System.IO;
using FastPoints.Build;
using FastPoints.Core;
using FastPoints.Drawing;
using FastPoints.Octrees;
using FastPoints.Store;
using FastPoints.Tests.Nodes;
using FastPoints.Tests.Streaming;
using FastPoints.Tests.Support;
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
        readonly int3[] m_places = new int3[Points];
        CoroutineStack m_build;

        public GrowingCloud()
        {
            var random = new Unity.Mathematics.Random(3);
            for (int i = 0; i < Points; i++)
                m_places[i] = new int3(random.NextInt2(20000), random.NextInt(100));
            Folder = m_scratch.File("cloud" + StoreFormat.FolderExtension);
            Source = m_scratch.File("scan");
            CloudFeeds.Register(paths => new SourceFeed(Open(), PreviewPoints));
        }

        /// <summary>The converted cloud's.</summary>
        public string Folder { get; }

        /// <summary>A file that is there when something of the build can be seen.</summary>
        public string Manifest => Path.Combine(Folder + StoreFormat.PartSuffix, StoreFormat.ManifestName);

        /// <summary>What the readers know.</summary>
        public string Source { get; }

        /// <summary>Whether the build is at its end.</summary>
        public bool IsBuilt { get; private set; }

        MemoryReader Open()
        {
            var centimetres = new PositionTransform { Scale = 0.01, Offset = StreamedTestCloud.OriginGeo };
            return MemoryReader.Of(m_places, centimetres, 5000);
        }

        /// <summary>Goes on with the build for a step; begins it.</summary>
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

        /// <summary>Breaks the build off: nothing is left of it.</summary>
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
