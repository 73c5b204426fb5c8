using System.Linq;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public sealed class CloudVersionsTests
    {
        StreamedTestCloud m_cloud;
        StreamContext m_stream;
        CloudVersions m_versions;

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud(20_000, 8000);

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void Begin()
        {
            m_stream = StreamedTestCloud.Stream();
            m_versions = new CloudVersions(m_stream);
        }

        [TearDown]
        public void End() => m_stream.Dispose();

        void Add(CloudStage stage)
        {
            m_versions.Add(m_cloud.Open(), null, stage);
            for (int frame = 0; frame < 1_000_000 && (frame < 2 || !m_versions.IsCurrent); frame++)
            {
                StreamedTestCloud.Frame(m_stream, StreamedTestCloud.Overview());
                m_versions.Update();
            }
            Assert.That(m_versions.IsCurrent, Is.True);
        }

        int[] Shown() => Enumerable.Range(0, m_stream.Clouds.Count)
            .Where(c => m_stream.Clouds[c] != null && !m_stream.Clouds[c].IsRemoving).ToArray();

        [Test]
        public void Update_PreviewBesideABuild_StaysUntilTheBuildIsFinished()
        {
            Add(CloudStage.Preview);
            int preview = m_versions.ShownNumber;
            Add(CloudStage.Building);
            Assert.That(m_versions.Preview, Is.EqualTo(preview));
            Assert.That(Shown(), Is.EquivalentTo(new[] { preview, m_versions.ShownNumber }));

            Add(CloudStage.Building);
            Assert.That(m_versions.Preview, Is.EqualTo(preview));
            Assert.That(Shown(), Is.EquivalentTo(new[] { preview, m_versions.ShownNumber }));

            int build = m_versions.ShownNumber;
            Add(CloudStage.Preview);
            Assert.That(m_versions.ShownNumber, Is.EqualTo(build), "a better preview takes the preview's place alone");
            Assert.That(Shown(), Is.EquivalentTo(new[] { m_versions.Preview, build }));

            Add(CloudStage.Whole);
            Assert.That(m_versions.Preview, Is.EqualTo(CloudVersions.None));
            Assert.That(Shown(), Is.EqualTo(new[] { m_versions.ShownNumber }));
        }

        [Test]
        public void DropBuild_BuildWithPreview_ShowsThePreview()
        {
            Add(CloudStage.Preview);
            int preview = m_versions.ShownNumber;
            Add(CloudStage.Building);
            Assert.That(m_versions.DropBuild(), Is.True);
            Assert.That(m_versions.ShownNumber, Is.EqualTo(preview));
            Assert.That(Shown(), Is.EqualTo(new[] { preview }));
            Assert.That(m_versions.DropBuild(), Is.False);
        }

        [Test]
        public void DropBuild_BuildWithoutPreview_IsShownUntilAPreviewExists()
        {
            Add(CloudStage.Building);
            int build = m_versions.ShownNumber;
            m_versions.DropBuild();
            Assert.That(Shown(), Is.EqualTo(new[] { build }));
            Add(CloudStage.Preview);
            Assert.That(m_versions.ShownNumber, Is.Not.EqualTo(build));
            Assert.That(Shown(), Is.EqualTo(new[] { m_versions.ShownNumber }));
        }

        [Test]
        public void Place_StatesWithOtherCubes_KeepsPositions()
        {
            using var other = new StreamedTestCloud(3000, 8000, 12);
            var random = new Random(5);
            var linear = new double3x3(random.NextDouble3(), random.NextDouble3(), random.NextDouble3());
            m_versions.Add(m_cloud.Open(), null, CloudStage.Preview);
            m_versions.Add(other.Open(), null, CloudStage.Whole);
            m_versions.Place(new CloudPlacement(linear, random.NextDouble3() * 1000));
            var shown = m_stream.Clouds[m_versions.ShownNumber];
            var next = m_stream.Clouds[m_versions.Next];
            var geo = StreamedTestCloud.OriginGeo + new double3(10, 20, 3);
            double3 At(StreamedCloud cloud) => cloud.Placement.OriginWorld + math.mul(cloud.Placement.Linear,
                geo - cloud.Source.Grid.ToGeo(cloud.Source.Root.Corner));
            Assert.That(math.length(At(shown) - At(next)), Is.LessThan(1e-8));
        }
    }
}
