using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Benchmarks;
using FastPoints.Store;
using FastPoints.Streaming;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Tests.Streaming
{
    [Category("Smoke")]
    public unsafe class SelectNodesTests
    {
        const int Levels = 7;
        static readonly double3 s_middle = new double3(4096, 4096, 300);

        LodSelector m_selector;
        SimulatedHierarchy m_cloud;
        LodSettings m_settings;

        [SetUp]
        public void MakeCloud()
        {
            m_selector = new LodSelector();
            m_cloud = new SimulatedHierarchy(Levels, 1);
            m_settings = LodSettings.Default;
        }

        [TearDown]
        public void FreeCloud()
        {
            m_selector.Dispose();
            m_cloud.Dispose();
        }

        static StreamView Looking(double3 eye, double3 forward, double fovDegrees = 60)
        {
            forward = math.normalize(forward);
            var right = math.normalize(math.cross(forward, new double3(0.01, 0.02, 1)));
            return StreamView.Perspective(eye, right, math.cross(right, forward), forward, math.radians(fovDegrees),
                new double2(1280, 720));
        }

        static CloudPlacement At(double3 origin) => new CloudPlacement(double3x3.identity, origin);

        List<(int Cloud, int Page, int Node)> Choose(StreamView view, params CloudPlacement[] placements) =>
            Choose(new[] { view }, placements);

        List<(int Cloud, int Page, int Node)> Choose(StreamView[] views, params CloudPlacement[] placements)
        {
            m_selector.Begin();
            for (int c = 0; c < placements.Length; c++)
                m_selector.Add(c, m_cloud.Pages, placements[c]);
            using (var native = new NativeArray<StreamView>(views, Allocator.TempJob))
                m_selector.Select(native, m_settings);
            return m_selector.Selected.ToArray().Select(n => (n.Cloud, n.Page, n.Node)).ToList();
        }

        [Test]
        public void SpacingScale_OfCellsThatAreNoCubes_IsOfTheirLongestEdge()
        {
            Assert.That(CloudView.SpacingScaleOf(new double3(78_000, 111_000, 1), new double3(1e-7, 1e-7, 0.01)),
                Is.EqualTo(1.11).Within(1e-9), "cells of 1e-7 degrees by 1 cm are 1.1 cm long, not 1.1 km");
            Assert.That(CloudView.SpacingScaleOf(new double3(2, 3, 4), new double3(1, 1, 1)), Is.EqualTo(4));
            Assert.That(CloudView.SpacingScaleOf(new double3(1, 1, 1), new double3(0.01, 0.01, 0.001)), Is.EqualTo(1));
            Assert.That(CloudView.SpacingScaleOf(new double3(1, 2, 3), default), Is.EqualTo(3), "unknown cells");
        }

        [Test]
        public void Select_AnyView_HasParentsFirstWithinTheBudget()
        {
            foreach (long budget in new[] { 1L, 200_000, 5_000_000, 1_000_000_000 })
            {
                m_settings.PointBudget = budget;
                var chosen = Choose(Looking(s_middle, new double3(1, 0.3, -0.4)), At(0));
                Assert.That(chosen, Is.Unique);
                Assert.That(m_selector.Points, Is.EqualTo((long)chosen.Count * SimulatedHierarchy.PointsPerNode));
                Assert.That(m_selector.Points, Is.LessThanOrEqualTo(math.max(budget, SimulatedHierarchy.PointsPerNode)));
                for (int i = 1; i < chosen.Count; i++)
                {
                    var node = m_selector.Selected[i];
                    Assert.That(node.Parent, Is.InRange(0, i - 1));
                    var parent = m_selector.Selected[node.Parent];
                    var above = m_cloud.Pages[parent.Page].Nodes[parent.Node];
                    bool isChild = node.Page == parent.Page
                        ? node.Node >= above.FirstChild && node.Node < above.FirstChild + above.ChildCount
                        : node.Page >= above.FirstPage && node.Page < above.FirstPage + above.PageCount;
                    Assert.That(isChild, Is.True, "place " + i);
                }
            }
        }

        [Test]
        public void Select_LightBesideACamera_TakesAFifthOfTheBudgetAtMost()
        {
            m_settings.PointBudget = 2_000_000;
            var camera = Looking(s_middle, new double3(1, 0.3, -0.4));
            camera.ScalePx /= 20;
            var seen = Choose(camera, At(0));
            long pointsSeen = m_selector.Points;
            var light = StreamView.Everything(camera.ScalePx);
            light.IsLight = true;
            var both = Choose(new[] { camera, light }, At(0));
            Assert.That(seen, Is.SubsetOf(both));
            Assert.That(m_selector.Points - pointsSeen, Is.InRange(m_settings.PointBudget / 10, m_settings.PointBudget / 5));
        }

        [Test]
        public void Select_NoBudget_SelectsAllVisibleCoarseNodes()
        {
            m_settings.PointBudget = long.MaxValue;
            m_settings.MinScreenErrorPx = 1.5f;
            m_settings.MinNodePx = 0;
            var eye = s_middle;
            var forward = math.normalize(new double3(0.8, -1, -0.3));
            var right = math.normalize(math.cross(forward, new double3(0, 0, 1)));
            var up = math.cross(right, forward);
            var view = StreamView.Perspective(eye, right, up, forward, math.radians(50.0), new double2(1000, 500));
            var chosen = new HashSet<(int, int, int)>(Choose(view, At(0)));

            double tanY = math.tan(math.radians(25.0)), tanX = 2 * tanY;
            var wanted = new HashSet<(int, int, int)>();
            for (int p = 0; p < m_cloud.PageCount; p++)
            {
                for (int n = 0; n < m_cloud.Pages[p].NodeCount; n++)
                {
                    var node = m_cloud.Pages[p].Nodes[n];
                    // A point of a grid in the box that lies in the picture proves that the box does.
                    bool isSeen = false;
                    for (int i = 0; i < 9 * 9 * 9 && !isSeen; i++)
                    {
                        var position = node.Center + (double3)node.Half * (new double3(i % 9, i / 9 % 9, i / 81) / 4 - 1);
                        var from = position - eye;
                        double depth = math.dot(from, forward);
                        isSeen = depth > 0 && math.abs(math.dot(from, right)) <= tanX * depth &&
                            math.abs(math.dot(from, up)) <= tanY * depth;
                    }
                    double spacingAbove = 2 * node.Spacing;
                    double distance = math.length(math.max(math.abs(eye - node.Center) - node.Half, 0));
                    double screenErrorPx = spacingAbove * 250 / tanY / math.max(distance, spacingAbove);
                    if ((p == 0 && n == 0) || (isSeen && screenErrorPx > 1.501))
                        wanted.Add((0, p, n));
                    // Nothing that is too fine, or wholly behind the eye, is chosen.
                    if (p > 0 && chosen.Contains((0, p, n)))
                    {
                        Assert.That(screenErrorPx, Is.GreaterThan(1.499));
                        Assert.That(math.dot(node.Center - eye, forward), Is.GreaterThan(-math.length(node.Half)));
                    }
                }
            }
            Assert.That(wanted, Is.SubsetOf(chosen));
            Assert.That(wanted.Count, Is.GreaterThan(100).And.GreaterThan(0.8 * chosen.Count));
        }

        [Test]
        public void Select_CloudAndCameraMovedTogether_IsTheSame()
        {
            var eye = s_middle;
            var forward = new double3(1, 0.3, -0.4);
            var wanted = Choose(Looking(eye, forward), At(0));

            // Far away, where a float has steps of half a metre.
            var far = new double3(6_000_000, -9_000_000, 4000);
            Assert.That(Choose(Looking(eye + far, forward), At(far)), Is.EqualTo(wanted));

            // Turned about an odd axis, mirrored and a thousand times smaller.
            var turn = Turned(new double3(1, 2, 3), 0.7);
            turn.c0 *= -1;
            var linear = new double3x3(turn.c0 * 0.001, turn.c1 * 0.001, turn.c2 * 0.001);
            var moved = new CloudPlacement(linear, new double3(17, -5, 900));
            var f = math.normalize(forward);
            var r = math.normalize(math.cross(f, new double3(0.01, 0.02, 1)));
            var view = StreamView.Perspective(math.mul(linear, eye) + moved.OriginWorld, math.mul(turn, r),
                math.mul(turn, math.cross(r, f)), math.mul(turn, f), math.radians(60.0), new double2(1280, 720));
            Assert.That(Choose(view, moved), Is.EqualTo(wanted));
        }

        static double3x3 Turned(double3 axis, double angle)
        {
            axis = math.normalize(axis);
            double s = math.sin(angle), c = math.cos(angle);
            double3 Turn(double3 v) => v * c + math.cross(axis, v) * s + axis * (math.dot(axis, v) * (1 - c));
            return new double3x3(Turn(new double3(1, 0, 0)), Turn(new double3(0, 1, 0)), Turn(new double3(0, 0, 1)));
        }

        [Test]
        public void Select_CloudScaledByItsTransform_EqualsAScaledCloud()
        {
            var stretch = new double3(3, 0.5, 10);
            var view = Looking(s_middle * stretch, new double3(1, 0.3, -0.4));
            var linear = new double3x3(new double3(stretch.x, 0, 0), new double3(0, stretch.y, 0), new double3(0, 0, stretch.z));
            var byTransform = Choose(view, new CloudPlacement(linear, 0));
            m_cloud.Dispose();
            m_cloud = new SimulatedHierarchy(Levels, stretch);
            var inItself = Choose(view, At(0));

            // Boxes of the one are rounded before, of the other after they are stretched.
            Assert.That(byTransform.Intersect(inItself).Count(), Is.GreaterThan(0.99 * inItself.Count));
            Assert.That(byTransform.Count, Is.EqualTo(inItself.Count).Within(1));
        }

        [Test]
        public void Select_SeveralCloudsAndViews_ShareTheBudget()
        {
            var view = Looking(s_middle, new double3(1, 0, -0.3));
            var near = At(0);
            var farther = At(new double3(12_000, 0, 0));
            var both = Choose(view, near, farther);
            Assert.That(m_selector.Points, Is.LessThanOrEqualTo(m_settings.PointBudget));
            Assert.That(both.Count(n => n.Cloud == 1), Is.InRange(2, both.Count / 3));

            // Two eyes a hand apart need what one needs; looking back as well takes from what is ahead.
            var eyes = Choose(new[] { view, Looking(s_middle + new double3(0, 0.065, 0), new double3(1, 0, -0.3)) }, near);
            var one = Choose(view, near);
            Assert.That(eyes.Intersect(one).Count(), Is.GreaterThan(0.95 * one.Count));
            var back = Choose(new[] { view, Looking(s_middle, new double3(-1, 0, -0.3)) }, near);
            Assert.That(m_selector.Points, Is.LessThanOrEqualTo(m_settings.PointBudget));
            Assert.That(back.Except(one).Count(), Is.GreaterThan(0.2 * one.Count));
        }

        [Test]
        public void Select_CloudWithoutVolume_IsSkipped()
        {
            var flat = new CloudPlacement(new double3x3(new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 0)), 0);
            Assert.That(Choose(Looking(s_middle, new double3(1, 0, 0)), flat, At(new double3(double.NaN, 0, 0))), Is.Empty);
        }

        [Test]
        public void Select_SameViews_NeverChanges()
        {
            m_settings.PointBudget = 1_234_567;
            var view = Looking(s_middle, new double3(1, 0.3, -0.4));
            var first = Choose(view, At(0));
            for (int i = 0; i < 5; i++)
                Assert.That(Choose(view, At(0)), Is.EquivalentTo(first));
        }

        [Test]
        public void Select_JitteringCamera_ChangesLessWithHysteresis()
        {
            int Changes(float hysteresis)
            {
                m_settings.Hysteresis = hysteresis;
                m_settings.PointBudget = 1_000_000;
                int changes = 0;
                List<(int, int, int)> before = null;
                for (int i = 0; i < 60; i++)
                {
                    var eye = s_middle + 5 * new double3(math.sin(i * 1.7), math.cos(i * 2.3), math.sin(i * 3.1));
                    // All around: what comes and goes at the picture's edge is another matter.
                    var view = Looking(eye, new double3(1, 0.3, -0.4));
                    view.PlaneCount = 0;
                    var now = Choose(view, At(0));
                    changes += before == null ? 0 : before.Except(now).Count() + now.Except(before).Count();
                    before = now;
                }
                return changes;
            }
            int without = Changes(1);
            Assert.That(without, Is.GreaterThan(20), "the test would prove nothing");
            Assert.That(Changes(1.15f), Is.LessThanOrEqualTo(without / 4));
        }

        [Test]
        public void Select_PageNotLoaded_IsRequestedByPriorityAndTheRestIsChosen()
        {
            var view = Looking(s_middle, new double3(1, 0.3, -0.4));
            int nearest = Choose(view, At(0)).First(n => n.Page > 0).Page;
            m_cloud.Pages[nearest].Status = HierarchyPageStatus.Absent;
            var chosen = Choose(view, At(0));
            Assert.That(m_selector.Missing[0].Page, Is.EqualTo(nearest));
            Assert.That(chosen.Select(n => n.Page), Has.None.EqualTo(nearest).And.Some.GreaterThan(0));

            m_cloud.Pages[nearest].Status = HierarchyPageStatus.Failed;
            Choose(view, At(0));
            Assert.That(m_selector.Missing.ToArray(), Is.Empty);
            m_cloud.Pages[nearest].Status = HierarchyPageStatus.Loaded;
        }

        [Test]
        public void Prefetch_FutureCamera_SelectsItsNodesAndNothingTwice()
        {
            var now = Looking(s_middle, new double3(1, 0.3, -0.4));
            var soon = Looking(s_middle + new double3(300, 90, -20), new double3(1, 0.35, -0.4));
            var chosen = Choose(now, At(0));
            using (var views = new NativeArray<StreamView>(new[] { soon }, Allocator.TempJob))
                m_selector.Prefetch(views, m_settings, 200_000);
            var limit = m_selector.Prefetched.ToArray().Select(n => (n.Cloud, n.Page, n.Node)).ToList();
            Assert.That(limit.Count, Is.EqualTo(20));
            Assert.That(limit.Intersect(chosen), Is.Empty);
            Assert.That(m_selector.Selected.Length, Is.EqualTo(chosen.Count));
            Assert.That(limit.Except(Choose(soon, At(0))).Count(), Is.LessThanOrEqualTo(2));
        }
    }
}
