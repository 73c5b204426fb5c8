using System;
using System.Linq;
using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    public sealed class FadeTests
    {
        const float Step = 0.125f;

        StreamedTestCloud m_cloud;
        StreamContext m_stream;

        static Camera Here => StreamedTestCloud.Near(60, 60, 0.6);

        [OneTimeSetUp]
        public void MakeCloud() => m_cloud = new StreamedTestCloud();

        [OneTimeTearDown]
        public void DeleteCloud() => m_cloud.Dispose();

        [SetUp]
        public void Open()
        {
            m_stream = StreamedTestCloud.Stream();
            var source = m_cloud.Open();
            m_stream.Add(source, StreamedTestCloud.Geo(source));
            m_stream.Settings.FadeSeconds = 1;
            m_stream.FrameSeconds = Step;
        }

        [TearDown]
        public void Close() => m_stream.Dispose();

        DrawnNode[] Drawn => m_stream.Drawn.AsArray().ToArray();

        // How far a node has appeared, in time.
        float FadeOf(DrawnNode node) => m_stream.Cache[node.Slot].Fade;

        static (int, int, int) Of(DrawnNode node) => (node.Cloud, node.Page, node.Node);

        FrameStats Frame() => StreamedTestCloud.Frame(m_stream, Here);

        // With all nodes of the view in memory, but those above 4,000 points not drawn.
        void SettleFew()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            m_stream.Settings.Selection.PointBudget = 4000;
            StreamedTestCloud.Settle(m_stream, Here);
        }

        [Test]
        public void Run_NodesArrive_FadeInWithinFadeSeconds()
        {
            FrameStats stats;
            var last = Drawn.ToDictionary(Of, FadeOf);
            int begun = 0;
            do
            {
                stats = Frame();
                foreach (var node in Drawn)
                {
                    float wanted = last.TryGetValue(Of(node), out float before) ? math.min(1, before + Step) : 0;
                    Assert.That(FadeOf(node), Is.EqualTo(wanted));
                    begun += wanted == 0 ? 1 : 0;
                }
                last = Drawn.ToDictionary(Of, FadeOf);
                Assert.That(stats.FadingNodes, Is.EqualTo(Drawn.Count(n => n.DrawnFraction < 1)));
            }
            while (!stats.IsSettled);
            Assert.That(begun, Is.EqualTo(Drawn.Length).And.GreaterThan(20));
            Assert.That(Drawn, Has.All.Matches<DrawnNode>(n => n.DrawnFraction == 1));
            Assert.That(stats.DrawnPoints, Is.EqualTo(stats.SelectedPoints));
        }

        [Test]
        public void Run_NodesArrive_HaveNoGreaterShareThanTheirParents()
        {
            int between = 0;
            do
            {
                Frame();
                var drawn = Drawn;
                foreach (var node in drawn.Where(n => n.Parent >= 0))
                {
                    float above = drawn[node.Parent].DrawnFraction;
                    Assert.That(node.DrawnFraction, Is.LessThanOrEqualTo(above));
                    Assert.That(FadeOf(node) < 1 || node.DrawnFraction == above);
                    between += node.DrawnFraction > 0 && node.DrawnFraction < above ? 1 : 0;
                }
            }
            while (m_stream.Drawn.Length == 0 || m_stream.IsFading);
            Assert.That(between, Is.GreaterThan(20));
        }

        [Test]
        public void Run_NodesComeIntoView_AreWholeAtOnce()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            var here = Drawn.Select(Of).ToHashSet();
            StreamedTestCloud.Settle(m_stream, StreamedTestCloud.Near(60, 60, 0.6 + math.PI));
            Assert.That(Drawn.Count(n => here.Contains(Of(n))), Is.LessThan(here.Count / 2));
            var stats = Frame();
            Assert.That(Drawn.Count(n => here.Contains(Of(n))), Is.EqualTo(here.Count));
            Assert.That(stats.FadingNodes, Is.Zero);
        }

        [Test]
        public void Run_NodesNoLongerSelected_FadeOut()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            var all = Drawn.Select(Of).ToArray();
            m_stream.Settings.Selection.MinScreenErrorPx = 20;
            for (int frame = 1; frame < 8; frame++)
            {
                var stats = Frame();
                Assert.That(Drawn.Select(Of), Is.EquivalentTo(all));
                var fadingOut = Drawn.Where(n => n.DrawnFraction < 1).ToArray();
                Assert.That(fadingOut, Has.Length.EqualTo(all.Length - stats.SelectedNodes).And.Length.GreaterThan(20));
                Assert.That(fadingOut, Has.All.Matches<DrawnNode>(n => FadeOf(n) == 1 - frame * Step));
                Assert.That(Drawn.Where((n, i) => n.Parent >= i), Is.Empty);
                Assert.That(stats.IsSettled, Is.False);
            }
            Assert.That(Frame().IsSettled, Is.True);
            Assert.That(Drawn, Has.Length.EqualTo(m_stream.Selector.Selected.Length));
        }

        [Test]
        public void Run_NodesSelectedAgainWhileFadingOut_FadeInFromThere()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            m_stream.Settings.Selection.MinScreenErrorPx = 20;
            for (int frame = 0; frame < 4; frame++)
                Frame();
            m_stream.Settings.Selection.MinScreenErrorPx = StreamedTestCloud.Selection.MinScreenErrorPx;
            Frame();
            Assert.That(Drawn.Min(FadeOf), Is.EqualTo(1 - 3 * Step));
        }

        [Test]
        public void Run_FadingOutNodesExceedTheBudget_AreNotDrawn()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            m_stream.Settings.Selection.PointBudget = 4000;
            for (int frame = 0; frame < 10; frame++)
                Assert.That(Frame().DrawnPoints, Is.LessThanOrEqualTo(4000));
            Assert.That(m_stream.IsFading, Is.False);
        }

        [Test]
        public void Run_MemoryOfFadingOutNodesIsNeeded_EvictsThem()
        {
            StreamedTestCloud.Settle(m_stream, Here);
            m_stream.Settings.Selection.MinScreenErrorPx = 20;
            Frame();
            Assert.That(m_stream.IsFading, Is.True);
            m_stream.Pool.LimitBytes = m_stream.Pool.BankBytes;
            for (int frame = 0; frame < 10; frame++)
            {
                var stats = Frame();
                Assert.That(stats.PoolBytes, Is.LessThanOrEqualTo(m_stream.Pool.LimitBytes));
                foreach (var node in Drawn)
                    Assert.That(m_stream.Cache[node.Slot].Phase, Is.EqualTo(CachePhase.Resident));
            }
            Assert.That(m_stream.Pool.FindProblem(), Is.Null);
        }

        [Test]
        public void Run_CloudRemovedWhileItFades_IsNotDrawn()
        {
            SettleFew();
            m_stream.Settings.Selection.PointBudget = 2_000_000;
            Frame();
            Frame();
            Assert.That(m_stream.IsFading, Is.True);
            m_stream.Remove(0);
            Frame();
            Assert.That(m_stream.Drawn.Length, Is.Zero);
            Assert.That(m_stream.IsFading, Is.False);
        }

        [TestCase(0)]
        [TestCase(0.1f)]
        public void Run_FadeNoLongerThanAFrame_DrawsNodesWhole(float seconds)
        {
            m_stream.Settings.FadeSeconds = seconds;
            FrameStats stats;
            do
            {
                stats = Frame();
                Assert.That(stats.FadingNodes, Is.Zero);
            }
            while (!stats.IsSettled);
        }

        [Test]
        public unsafe void Gap_NodeFadesIn_GoesFromItsParentsToItsOwn()
        {
            SettleFew();
            m_stream.Settings.Selection.PointBudget = 2_000_000;
            using var sizes = new SizeTree();
            int checkedNodes = 0, between = 0;
            for (int frame = 0; frame <= 8; frame++)
            {
                Frame();
                sizes.Build(m_stream);
                for (int i = 0; i < m_stream.Drawn.Length; i++)
                {
                    var node = m_stream.Drawn[i];
                    var stored = m_stream.Clouds[0].Pages[node.Page].Nodes[node.Node];
                    if (node.Parent < 0 || stored.ChildCount + stored.PageCount == 0)
                        continue;
                    float gapAbove = sizes.Nodes[sizes.NodeOfDrawn[node.Parent]].Gap, own = stored.Spacing;
                    float above = m_stream.Drawn[node.Parent].DrawnFraction;
                    double share = node.DrawnFraction >= above ? 1 : node.DrawnFraction / (double)above;
                    double wanted = 1 / math.sqrt((1 - share) / ((double)gapAbove * gapAbove) + share / ((double)own * own));
                    between += share > 0 && share < 1 ? 1 : 0;
                    Assert.That(sizes.Nodes[sizes.NodeOfDrawn[i]].Gap, Is.EqualTo(wanted).Within(3e-5).Percent);
                    checkedNodes++;
                }
            }
            Assert.That(checkedNodes, Is.GreaterThan(50));
            Assert.That(between, Is.GreaterThan(10));
        }

        [Test]
        public void IsDrawn_ManyPoints_KeepsTheShare([Values(0.1f, 0.25f, 0.5f, 0.9f, 1)] float fade, [Values(0, 77)] int number)
        {
            uint bits = PointFade.BitsOf(new DrawnNode { Cloud = 1, Page = 3, Node = number, DrawnFraction = fade });
            uint before = PointFade.BitsOf(new DrawnNode { Cloud = 1, Page = 3, Node = number, DrawnFraction = fade - 0.05f });
            int drawn = 0, inHalf = 0;
            for (uint i = 0; i < 10_000; i++)
            {
                bool isDrawn = DrawBlocksJob.IsDrawn(bits, i);
                drawn += isDrawn ? 1 : 0;
                inHalf += isDrawn && i % 2 == 0 ? 1 : 0;
                Assert.That(isDrawn || !DrawBlocksJob.IsDrawn(before, i), "a point that is drawn stays");
            }
            // A threshold is rounded to a 4096th; five standard deviations of so many points.
            Assert.That(drawn / 10_000.0, Is.EqualTo(fade).Within(1 / 4096.0 + 5 * Math.Sqrt(fade * (1 - fade) / 10_000)));
            Assert.That(inHalf / 5000.0, Is.EqualTo(fade).Within(1 / 4096.0 + 5 * Math.Sqrt(fade * (1 - fade) / 5000)));
        }
    }
}
