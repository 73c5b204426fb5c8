using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using FastPoints.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Build
{
    [Category("Smoke")]
    public sealed class StreamSpoolTests : FolderTests
    {
        const int Length = (3 << 20) + 17;

        static byte[] Bytes()
        {
            var bytes = new byte[Length];
            new System.Random(1).NextBytes(bytes);
            return bytes;
        }

        sealed class SlowStream : MemoryStream
        {
            readonly System.Random m_random = new System.Random(2);

            public SlowStream(byte[] bytes) : base(bytes) { }

            public ManualResetEventSlim WaitsFor;
            public bool IsDisposed { get; private set; }

            public override int Read(byte[] buffer, int offset, int count)
            {
                WaitsFor?.Wait();
                return base.Read(buffer, offset, Math.Min(count, m_random.Next(1, 9000)));
            }

            protected override void Dispose(bool disposing)
            {
                IsDisposed = true;
                base.Dispose(disposing);
            }
        }

        [TestCase(-1), TestCase(Length)]
        public void Spool_Stream_WritesTheFile(long length)
        {
            string path = Folder.File("scan.las");
            File.WriteAllText(path, "what was there before");
            var stream = new SlowStream(Bytes());
            using var spool = new StreamSpool(() => stream, path, length);
            spool.Work.GetAwaiter().GetResult();
            Assert.That(File.ReadAllBytes(path), Is.EqualTo(Bytes()));
            Assert.That((spool.Fraction, spool.Bytes, stream.IsDisposed), Is.EqualTo((1.0, (long)Length, true)));
            Assert.That(Directory.GetFiles(Folder.Path), Is.EqualTo(new[] { path }));
        }

        [Test]
        public void Spool_TruncatedStream_ReportsItAndLeavesNothing()
        {
            string path = Folder.File("scan.las");
            using var spool = new StreamSpool(() => new SlowStream(Bytes()), path, Length + 1);
            Failures.Of(() => spool.Work.GetAwaiter().GetResult(), FailureCode.Truncated, "scan.las", (Length + 1).ToString());
            Assert.That(Directory.GetFiles(Folder.Path), Is.Empty);
        }

        [Test]
        public void Spool_MissingFolder_ReportsIt()
        {
            string path = Folder.File("none/scan.las");
            using var spool = new StreamSpool(() => new SlowStream(Bytes()), path);
            Failures.Of(() => spool.Work.GetAwaiter().GetResult(), FailureCode.NotFound);
        }

        [Test]
        public void Dispose_WhileDownloading_LeavesNothing()
        {
            using var hasMore = new ManualResetEventSlim();
            string path = Folder.File("scan.las");
            var spool = new StreamSpool(() => new SlowStream(Bytes()) { WaitsFor = hasMore }, path);
            spool.Dispose();
            hasMore.Set();
            Assert.Throws(Is.InstanceOf<OperationCanceledException>(), () => spool.Work.GetAwaiter().GetResult());
            Assert.That(spool.Work.Status, Is.Not.EqualTo(TaskStatus.RanToCompletion));
            Assert.That(Directory.GetFiles(Folder.Path), Is.Empty);
        }
    }
}
