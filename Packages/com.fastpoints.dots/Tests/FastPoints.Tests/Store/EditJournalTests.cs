using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    public class EditJournalTests : FolderTests
    {
        const ulong Id = 0x1234;

        string Cloud => Folder.File("scan.fastpoints");
        string PathOfEdits => Cloud + ".edits";

        [TearDown]
        public void EndIntercept() => FileChanges.Intercept = null;

        EditJournal Read() => EditJournal.Read(Cloud, Id);

        string[] Texts() => Read().Applied.ConvertAll(o => o.ToJson()).ToArray();

        static EditOperation Operation(int n)
        {
            var operation = new EditOperation { Action = (EditAction)(n % 4), PointsChanged = n + 1 };
            operation.Value = new byte[] { 9, 255, 0 }.Take(operation.ChangedAttributes.Length).ToArray();
            if (n % 2 == 0)
                operation.Boxes.Add(new EditShape { A = new Grid3(-5, n, 1L << 60), B = new Grid3(7, 8, 9) });
            for (int i = 0; i < 3 && n % 3 == 1; i++)
                operation.Balls.Add(new EditShape { A = new Grid3(i, -n, 2), B = new Grid3(4, 4, 4), IsBall = true });
            if (n % 3 == 2)
            {
                operation.Prism.Origin = new Grid3(1, 2, 3);
                operation.Prism.U = new Grid3(5, 0, -1);
                operation.Prism.V = new Grid3(0, 7, n);
                operation.Prism.W = n % 2 == 0 ? default : new Grid3(1, 0, -n);
                operation.AddRing(1, new long[] { 0, 0, n % 2 == 0 ? 1L << 60 : 1L << 31, 0, 5, 9 });
                operation.AddRing(2, new long[] { 1, 1, 2, 1, 2, 2 });
            }
            if (n % 5 != 0)
                operation.Conditions.Add(FilterExpression.Parse("Intensity > " + n + " && \"a name\" != 2"));
            return operation;
        }

        void Add(int count)
        {
            var journal = Read();
            for (int n = 0; n < count; n++)
                journal.Add(Operation(n));
        }

        [Test]
        public void Read_WithoutAFile_IsEmptyAndMakesNone()
        {
            Assert.That(Read().Count, Is.Zero);
            Assert.That(Read().TryUndo() || Read().TryRedo(), Is.False);
            Assert.That(File.Exists(PathOfEdits), Is.False);
        }

        [Test]
        public void Read_OfWhatWasAdded_IsTheSame()
        {
            Add(12);
            var texts = Enumerable.Range(0, 12).Select(n => Operation(n).ToJson()).ToArray();
            Assert.That(Texts(), Is.EqualTo(texts));
            Assert.That(texts.Distinct().Count(), Is.EqualTo(12));
        }

        [Test]
        public void UndoAndRedo_InOtherSessions_GoStepByStep()
        {
            Add(3);
            for (int left = 2; left >= 0; left--)
            {
                Assert.That(Read().TryUndo(), Is.True);
                Assert.That((Read().Count, Read().Operations.Count), Is.EqualTo((left, 3)));
            }
            Assert.That(Read().TryUndo(), Is.False);
            Assert.That(Read().TryRedo() && Read().TryRedo(), Is.True);
            Assert.That(Texts(), Is.EqualTo(new[] { Operation(0).ToJson(), Operation(1).ToJson() }));
            Read().Add(Operation(7));
            Assert.That(Texts(), Is.EqualTo(new[] { Operation(0).ToJson(), Operation(1).ToJson(), Operation(7).ToJson() }));
            Assert.That(Read().TryRedo(), Is.False, "what was undone is gone");
        }

        [Test]
        public void Read_CutAnywhere_KeepsWhatWasWhole()
        {
            var ends = new List<long>();
            for (int n = 0; n < 3; n++)
            {
                Read().Add(Operation(n));
                ends.Add(new FileInfo(PathOfEdits).Length);
            }
            byte[] bytes = File.ReadAllBytes(PathOfEdits);
            for (int length = 0; length <= bytes.Length; length += length % 5 == 0 ? 1 : 3)
            {
                int whole = ends.Count(end => end <= length);
                // A system that crashed may have kept the length and not the bytes, but for the header, which one sector has.
                int most = length > 0 && length < EditHeader.SizeBytes ? 0 : bytes.Length - length;
                foreach (int zeros in new[] { 0, most })
                {
                    File.WriteAllBytes(PathOfEdits, bytes.Take(length).Concat(new byte[zeros]).ToArray());
                    Assert.That(Read().Count, Is.EqualTo(whole), "cut at " + length + ", then zeros: " + zeros);
                }
                if (length % 10 != 0)
                    continue;
                Read().Add(Operation(5));
                Assert.That(Texts().Last(), Is.EqualTo(Operation(5).ToJson()));
                Assert.That(Read().Count, Is.EqualTo(whole + 1));
            }
        }

        [Test]
        public void Read_DamagedAnywhere_IsAnErrorOrLosesTheLast()
        {
            Add(3);
            byte[] bytes = File.ReadAllBytes(PathOfEdits);
            string[] whole = Texts();
            int errors = 0;
            for (int at = 0; at < bytes.Length; at += at < 60 ? 1 : 5)
            {
                var damaged = (byte[])bytes.Clone();
                damaged[at] ^= (byte)(1 << at % 8);
                File.WriteAllBytes(PathOfEdits, damaged);
                try
                {
                    Assert.That(Texts(), Is.EqualTo(whole.Take(Read().Count)), "byte " + at);
                    // A length that reaches beyond the end is what a cut leaves, too.
                    Assert.That(Read().Count, Is.LessThan(3).Or.EqualTo(at >= 12 && at < 16 ? 3 : -1), "byte " + at);
                }
                catch (PointCloudException e)
                {
                    Assert.That(e.Path, Is.EqualTo(PathOfEdits));
                    errors++;
                }
            }
            Assert.That(errors, Is.GreaterThan(bytes.Length / 15));
        }

        [Test]
        public void Read_OfAnotherCloud_IsOneClearError()
        {
            Add(1);
            var error = Assert.Throws<PointCloudException>(() => EditJournal.Read(Cloud, Id + 1));
            Assert.That(error.Message, Does.StartWith(PathOfEdits).And.Contains("another cloud").And.Contains("1235"));
            Assert.That(error.IsInputAtFault, Is.True);
        }

        [Test]
        public void Add_WhereOthersWroteMeanwhile_IsRefusedAndLosesNothing()
        {
            Add(1);
            var late = Read();
            Read().Add(Operation(1));
            Assert.That(Assert.Throws<PointCloudException>(() => late.Add(Operation(2))).Code, Is.EqualTo(FailureCode.Changed));
            Assert.That(Read().Count, Is.EqualTo(2));
        }

        [Test]
        public void Write_StoppedAtEveryChange_LeavesTheJournalWhole()
        {
            for (int stop = 0; stop < 6; stop++)
            {
                int left = stop;
                FileChanges.Intercept = (change, path, _) =>
                {
                    if (change == FileChange.Write && left-- == 0)
                        throw new NotSupportedException("stopped");
                };
                int done = 0;
                var journal = Read();
                int before = journal.Count;
                Assert.Throws<NotSupportedException>(() =>
                {
                    for (; ; done++)
                        journal.Add(Operation(done));
                });
                FileChanges.Intercept = null;
                Assert.That(Read().Count, Is.EqualTo(before + done));
                Assert.That(journal.Count, Is.EqualTo(before + done));
            }
        }

        [Test]
        public void Write_OnAFullDisk_SaysSoAndGoesOnLater()
        {
            Add(1);
            var journal = Read();
            bool isFull = true;
            FileChanges.Intercept = (change, path, _) =>
            {
                if (change == FileChange.Write && isFull)
                    throw new IOException("full", 28);
            };
            var error = Assert.Throws<PointCloudException>(() => journal.Add(Operation(1)));
            Assert.That(error.Code, Is.EqualTo(FailureCode.DiskFull));
            isFull = false;
            journal.Add(Operation(2));
            Assert.That(Texts().Last(), Is.EqualTo(Operation(2).ToJson()));
        }

        [TestCase("\"hide\"", "\"paint\""), TestCase("\"value\": []", "\"value\": [1]"),
         TestCase("\"value\": []", "\"lasso\": 1"),
         TestCase("Intensity", "="), TestCase("\"a\": [1, 2, 3]", "\"a\": [1, 2]"), TestCase("[4, 4, 4]", "[4, 4, -4]"),
         TestCase("[4, 4, 4]", "[4, 4, 2000000]"), TestCase("[1, 2, 3]", "[1, 2, 9223372036854775807]"),
         TestCase("\"prism\"", "\"pyramid\""),
         TestCase("\"pointsChanged\": 5,", ""), TestCase("\"at\": [", "\"at\": [7,"), TestCase("{", "[")]
        public void FromJson_OfWhatIsNoOperation_IsAnError(string part, string other)
        {
            var operation = new EditOperation { PointsChanged = 5 };
            operation.Boxes.Add(new EditShape { A = new Grid3(1, 2, 3), B = new Grid3(5, 6, 7) });
            operation.Balls.Add(new EditShape { A = new Grid3(0, 0, 0), B = new Grid3(4, 4, 4), IsBall = true });
            operation.AddRing(0, new long[] { 0, 0, 5, 0, 5, 5 });
            operation.Conditions.Add(FilterExpression.Parse("Intensity > 1"));
            string text = operation.ToJson().Replace("[\n", "[").Replace("[  ]", "[]");
            int at = text.IndexOf(part, StringComparison.Ordinal);
            Assert.That(EditOperation.FromJson(text, "a").ToJson(), Is.EqualTo(operation.ToJson()));
            Assert.That(at, Is.GreaterThanOrEqualTo(0), text);
            text = text.Remove(at, part.Length).Insert(at, other);
            Assert.That(Assert.Throws<PointCloudException>(() => EditOperation.FromJson(text, "a")).IsInputAtFault, Is.True);
        }

        [Test]
        public void Signed128_OfAnyProducts_IsExact()
        {
            var random = new System.Random(4);
            long Any() => random.Next(4) == 0 ? random.Next(-2, 3)
                : (long)(random.NextDouble() * ulong.MaxValue) >> random.Next(60);
            for (int i = 0; i < 2000; i++)
            {
                long a = Any(), b = Any(), c = Any() >> 2, d = Any() >> 2;
                BigInteger second = (BigInteger)c * d;
                var sum = Signed128.Product(a >> 1, b >> 1) + Signed128.Product(c, d);
                var wanted = (BigInteger)(a >> 1) * (b >> 1) + (BigInteger)c * d;
                Assert.That(sum.CompareTo(Signed128.Product(d, c)), Is.EqualTo(wanted.CompareTo(second)));
                long clamped = (long)BigInteger.Max(-5, BigInteger.Min(long.MaxValue - 1, wanted));
                Assert.That(sum.Clamp(-5, long.MaxValue - 1), Is.EqualTo(clamped));
                var quotient = second.IsZero ? 0 : (wanted - (wanted % second + second) % second) / second;
                if (second > 0 && second >> 90 == 0)
                    Assert.That(sum.Over(Signed128.Product(c, d), -(1L << 31), 1L << 31),
                        Is.EqualTo((long)BigInteger.Max(-(1L << 31), BigInteger.Min(1L << 31, quotient))));
            }
        }

        [Test]
        public void Box_OfCoordinates_HasThePositionsOnItsFaces()
        {
            var grid = new CloudGrid { Origin = new double3(441000.1, -3, 0.7), Step = new double3(0.001, 0.01, 0.1) };
            var random = new System.Random(3);
            for (int i = 0; i < 1000; i++)
            {
                var min = new Grid3(random.Next(-100000, 100000), random.Next(-100000, 100000), random.Next(-100000, 100000));
                var max = min + new Grid3(random.Next(1000), random.Next(1000), random.Next(1000));
                var box = EditShape.Box(grid, grid.ToGeo(min), grid.ToGeo(max));
                Assert.That(box.A == min && box.B == max, box.A + " to " + box.B);
                box = EditShape.Box(grid, grid.ToGeo(min) - grid.Step * 0.3, grid.ToGeo(max) + grid.Step * 0.7);
                Assert.That(box.A == min && box.B == max, box.A + " to " + box.B);
            }
        }
    }
}
