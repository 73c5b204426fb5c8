using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Reading
{
    public class FormatTableTests : FolderTests
    {
        static List<string[]> Rows() => Rows("formats.md");

        static List<string[]> Rows(string page)
        {
            string package = TestData.PackageRoot;
            string path = package == null ? null : Path.Combine(package, "Documentation~", page);
            if (path == null || !File.Exists(path))
                Assert.Ignore("the package's manual is not here");
            return File.ReadAllLines(path).SkipWhile(l => !l.StartsWith("| format |", StringComparison.Ordinal)).Skip(2)
                .TakeWhile(l => l.StartsWith("|", StringComparison.Ordinal))
                .Select(l => l.Trim('|', ' ').Split('|').Select(c => c.Trim()).ToArray()).ToList();
        }

        static IEnumerable<string> FormatsOf(string[] row) =>
            Regex.Matches(Regex.Replace(row[0], @"\(.*?\)", ""), "[A-Z][A-Za-z0-9]+").Cast<Match>().Select(m => m.Value);

        static IEnumerable<FormatFixture> Fixtures() => FormatFixture.All;

        [Test]
        public void EachRow_NamesTestsThatExist()
        {
            var classes = new HashSet<string>(typeof(FormatTableTests).Assembly.GetTypes().Select(t => t.Name));
            var rows = Rows("internals/readers.md");
            Assert.That(rows.Select(r => r[0]), Is.EqualTo(Rows().Select(r => r[0])), "each format of the manual");
            foreach (var row in rows)
            {
                Assert.That(row.Length, Is.EqualTo(2), row[0]);
                var named = Regex.Matches(row[1], "`(.*?)`").Cast<Match>().Select(m => m.Groups[1].Value).ToList();
                Assert.That(named, Is.Not.Empty, row[0]);
                Assert.That(named.Where(n => !classes.Contains(n)), Is.Empty, row[0]);
            }
        }

        [Test]
        public void EachRow_OfFormats_HasASampleCloud()
        {
            var known = new HashSet<string>(Fixtures().Select(f => f.Format));
            foreach (var row in Rows())
                Assert.That(FormatsOf(row).Where(known.Contains), Is.Not.Empty, row[0] + " has no fixture in FormatFixture.All");
        }

        [Test]
        public void EachFormat_HasARow()
        {
            var inTable = new HashSet<string>(Rows().SelectMany(FormatsOf));
            Assert.That(Fixtures().Select(f => f.Format).Where(f => !inTable.Contains(f)), Is.Empty);
        }

        [TestCaseSource(nameof(Fixtures))]
        public void Open_EachSampleCloud_HasItsFormat(FormatFixture fixture)
        {
            using var reader = PointReaders.Open(fixture.Write(Folder.Path));
            Assert.That(reader.Info.Format, Is.EqualTo(fixture.Format));
            ReadPoints.IndexBlocks(reader);
            Assert.That(reader.PointCount, Is.GreaterThan(0));
        }
    }
}
