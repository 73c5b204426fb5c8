using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using FastPoints.Editor;
using FastPoints.Streaming;
using NUnit.Framework;
using UnityEditor;

namespace FastPoints.HostTests.Editor
{
    /// <summary>What the inspectors tell and do, without their windows.</summary>
    public sealed class InspectorTests
    {
        [Test]
        public void ClassesOf_KnownRange_AreThoseThatMeanSomethingAndThoseThatAreHidden()
        {
            Assert.That(ClassFilter.ClassesOf(2, 9, new[] { 40 }), Is.EqualTo(new[] { 2, 3, 4, 5, 6, 7, 9, 40 }),
                "8 is reserved");
            Assert.That(ClassFilter.ClassesOf(8, 66, new int[0]).Where(c => c == 8 || c > 22),
                Is.EqualTo(new[] { 8, 64, 65, 66 }), "the least is there for sure");
            Assert.That(ClassFilter.ClassesOf(double.NaN, double.NaN, new int[0]), Does.Contain(2).And.Not.Contains(64));
            Assert.That(ClassFilter.ClassesOf(5, 5, new int[0]), Is.EqualTo(new[] { 5 }));
            Assert.That(new[] { 2, 8, 64 }.Select(ClassFilter.Label),
                Is.EqualTo(new[] { "2 ground", "8 reserved", "64 of the user" }));
        }

        [Test]
        public void Switch_AClass_AddsAndTakesIt()
        {
            var hidden = new[] { 2, 6 };
            Assert.That(ClassFilter.Switch(hidden, 2, false), Is.SameAs(hidden));
            Assert.That(ClassFilter.Switch(hidden, 3, true), Is.SameAs(hidden));
            Assert.That(ClassFilter.Switch(hidden, 3, false), Is.EqualTo(new[] { 2, 3, 6 }));
            Assert.That(ClassFilter.Switch(hidden, 2, true), Is.EqualTo(new[] { 6 }));
            Assert.That(hidden, Is.EqualTo(new[] { 2, 6 }), "Undo keeps what was");
        }

        [Test]
        public void Describe_AFrame_SaysWhatItDrewAndWhatIsUnderWay()
        {
            var stats = new FrameStats
            {
                DrawnPoints = 1_234_567,
                SelectedPoints = 2_000_000,
                DrawnNodes = 12,
                CachedNodes = 40,
                PoolBytes = 3 << 20,
                ReadsUnderWay = 3,
                SelectMs = 0.25,
                ListMs = 0.5,
            };
            var lines = FrameText.Describe(stats, 2_500_000, 512 << 20).ToDictionary(l => l.Key, l => l.Value);
            Assert.That(lines["Points"], Is.EqualTo("1,234,567 drawn of 2,000,000 selected, 2,500,000 at most"));
            Assert.That(lines["Graphics memory"], Is.EqualTo("3.0 of 512 MiB"));
            Assert.That(lines["Reads"], Does.StartWith("3 under way"));
            Assert.That(lines["Main thread"], Is.EqualTo("0.75 ms"));
            stats.IsSettled = true;
            Assert.That(FrameText.Describe(stats, 1, 1).Single(l => l.Key == "Reads").Value, Is.EqualTo("nothing is missing"));
        }

        [Test]
        public void Check_SoundAndDamagedCloud_SaysSo()
        {
            using (var project = new EditorProject())
            {
                var logged = new List<string>();
                UnityEngine.Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
                try
                {
                    var asset = project.Imports.Take(project.Scratch.Demo("scan.las", 20_000), "Assets");
                    project.UpdateToTheEnd();
                    string path = project.Paths.Absolute(asset.ProjectPath);
                    CloudCheck Verify()
                    {
                        project.Imports.Checks.Begin(path);
                        ImportProject.Updates(() => project.Imports.Update(DateTime.UtcNow),
                            () => !project.Imports.Checks.IsChecking);
                        return project.Imports.Checks.Check;
                    }
                    Assert.That(Verify().Describe(), Is.EqualTo("20,000 points are as they were converted"));
                    Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Succeeded));

                    string damaged = Directory.GetFiles(path, "*.bin", SearchOption.AllDirectories)
                        .OrderByDescending(f => new FileInfo(f).Length).First();
                    var bytes = File.ReadAllBytes(damaged);
                    bytes[bytes.Length / 2] ^= 4;
                    File.WriteAllBytes(damaged, bytes);
                    Assert.That(Verify().Describe(), Does.Match("^\\d+ problems:\n.*\\.bin"));
                    Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Failed));
                    Assert.That(logged.Last(), Does.StartWith("Error: FastPoints: " + path));

                    project.Imports.Checks.Begin(path);
                    Assert.That(Progress.Cancel(Progress.Entries.Count - 1), Is.True);
                    Assert.That(project.Imports.Checks.IsChecking, Is.False);
                    project.Imports.Checks.Begin(path);
                    project.Imports.Suspend();
                    Assert.That(Progress.Entries.Last().Status, Is.EqualTo(Progress.Status.Canceled));
                }
                finally
                {
                    UnityEngine.Debug.s_sink = null;
                }
            }
        }
    }
}
