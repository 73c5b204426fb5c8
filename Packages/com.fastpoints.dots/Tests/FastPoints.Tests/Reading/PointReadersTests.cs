using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Reading
{
    public class PointReadersTests : FolderTests
    {
        string FilePath => Folder.File("cloud");

        [TestCase("PK\u0003\u0004rest", "zip")]
        [TestCase("x y z\nnothing\n", "text \"x y z\"")]
        [TestCase("\u0001\u0002", "bytes 01-02")]
        [TestCase("LAS", "text \"LAS\"")]
        public void Open_ForeignFile_NamesWhatItIs(string content, string name)
        {
            File.WriteAllBytes(FilePath, Encoding.ASCII.GetBytes(content));
            CheckFailure(FailureCode.Unsupported, name);
        }

        static FormatFixture[] Fixtures() => FormatFixture.All.ToArray();

        [TestCaseSource(nameof(Fixtures))]
        public void Open_OnAPoolThread_CanBeCancelled(FormatFixture fixture)
        {
            string path = fixture.Write(Folder.Path);
            Task.Run(() => PointReaders.Open(path).DisposeUnread()).GetAwaiter().GetResult();
        }

        [Test]
        public void Open_MissingPath_IsNotFound() => CheckFailure(FailureCode.NotFound, "no such file");

        [Test]
        public void Open_EmptyFolder_IsUnsupported()
        {
            Directory.CreateDirectory(FilePath);
            CheckFailure(FailureCode.Unsupported, "has no point cloud");
        }

        [TestCase("cloud.json", "{\"format\":\"fastpoints\",\"version\":1}", "converted cloud already")]
        public void Open_FolderOrIndexOfAnotherKind_NamesWhatItIs(string name, string content, string detail)
        {
            string index = Folder.Write(name, content);
            foreach (string path in new[] { Folder.Path, index, Folder.Path + Path.DirectorySeparatorChar })
            {
                var failure = Failures.Of(() => PointReaders.Open(path), FailureCode.Unsupported, detail);
                Assert.That(failure.Path, Is.EqualTo(index));
            }
        }

        [Test]
        public void Open_JsonOfSomethingElse_IsNoCloud()
        {
            File.WriteAllText(FilePath, " { \"name\": \"x\", }");
            CheckFailure(FailureCode.Unsupported, "got the members name");
        }

        [TestCase("{\"a\":", "no JSON"), TestCase("{[", "no JSON")]
        public void Open_BrokenJson_NamesTheByte(string content, string detail)
        {
            File.WriteAllText(FilePath, content);
            CheckFailure(FailureCode.BadInput, detail);
        }

        [Test]
        public void Open_EmptyFile_IsTruncated()
        {
            File.WriteAllBytes(FilePath, new byte[0]);
            CheckFailure(FailureCode.Truncated, "0 bytes");
        }

        [Test]
        public void Open_Pipe_DoesNotWaitForAWriter()
        {
            Unix("mkfifo", FilePath);
            CheckFailure(FailureCode.Truncated, "0 bytes");
        }

        [Test]
        public void Open_NoPermission_IsAccessDenied()
        {
            File.WriteAllText(FilePath, "LASF");
            Unix("chmod", "000 " + FilePath);
            try
            {
                File.ReadAllBytes(FilePath);
            }
            catch (UnauthorizedAccessException)
            {
                CheckFailure(FailureCode.AccessDenied, "permission denied");
                return;
            }
            Assert.Ignore("this user may read any file");
        }

        [TestCase(null), TestCase(""), TestCase("no\0path")]
        public void Open_NoPath_IsOneLine(string path) =>
            Assert.That(() => PointReaders.Open(path), Throws.InstanceOf<PointCloudException>());

        void CheckFailure(FailureCode code, string detail)
        {
            var failure = Failures.Of(() => PointReaders.Open(FilePath).Dispose(), code, detail);
            Assert.That(failure.Path, Is.EqualTo(FilePath));
        }

        static void Unix(string command, string arguments)
        {
            if (Path.DirectorySeparatorChar != '/')
                Assert.Ignore("pipes and file modes are made the Unix way");
            using var process = Process.Start(new ProcessStartInfo(command, arguments) { UseShellExecute = false });
            process.WaitForExit();
        }
    }
}
