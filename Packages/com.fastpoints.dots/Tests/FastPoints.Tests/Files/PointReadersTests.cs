using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Tests.Support;
using NUnit.Framework;

namespace FastPoints.Tests.Files
{
    public class PointReadersTests
    {
        string m_path;

        [SetUp]
        public void NamePath() => m_path = Path.Combine(Path.GetTempPath(), "fastpoints-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void Delete() => File.Delete(m_path);

        [TestCase("# .PCD v.7 - Point Cloud Data", "PCD")]
        [TestCase("PK\u0003\u0004rest", "zip")]
        [TestCase("x y z\nnothing\n", "text \"x y z\"")]
        [TestCase("\u0001\u0002", "bytes 01-02")]
        [TestCase("LAS", "text \"LAS\"")]
        public void Open_ForeignFile_NamesWhatItIs(string content, string name)
        {
            File.WriteAllBytes(m_path, Encoding.ASCII.GetBytes(content));
            CheckFailure(FailureCode.Unsupported, name);
        }

        static FormatFixture[] Fixtures() => FormatFixture.All.ToArray();

        /// <summary>As where an opening is called off before anybody takes what it opened.</summary>
        [TestCaseSource(nameof(Fixtures))]
        public void Open_OnAThreadOfThePool_CanBeGivenUpThere(FormatFixture fixture)
        {
            Directory.CreateDirectory(m_path + "-folder");
            try
            {
                string path = fixture.Write(m_path + "-folder");
                Task.Run(() => PointReaders.Open(path).DisposeUnread()).GetAwaiter().GetResult();
            }
            finally
            {
                Directory.Delete(m_path + "-folder", true);
            }
        }

        [Test]
        public void Open_NothingThere_IsNotFound() => CheckFailure(FailureCode.NotFound, "no such file");

        [Test]
        public void Open_EmptyFolder_IsUnsupported()
        {
            Directory.CreateDirectory(m_path);
            CheckFailure(FailureCode.Unsupported, "has no point cloud");
            Directory.Delete(m_path);
        }

        [TestCase("cloud.json", "{\"format\":\"fastpoints\",\"version\":1}", "converted cloud already")]
        public void Open_FolderOrIndexOfAnotherKind_NamesWhatItIs(string name, string content, string story)
        {
            string folder = m_path + "-folder";
            string index = Path.Combine(folder, name);
            Directory.CreateDirectory(folder);
            try
            {
                File.WriteAllText(index, content, Encoding.UTF8);
                foreach (string path in new[] { folder, index, folder + Path.DirectorySeparatorChar })
                {
                    var failure = Assert.Throws<PointCloudException>(() => PointReaders.Open(path));
                    Assert.That(failure.Code, Is.EqualTo(FailureCode.Unsupported));
                    Assert.That(failure.Path, Is.EqualTo(index));
                    Assert.That(failure.Message, Does.Contain(story));
                }
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        [Test]
        public void Open_JsonOfSomethingElse_IsNoCloud()
        {
            File.WriteAllText(m_path, " { \"name\": \"x\", }");
            CheckFailure(FailureCode.Unsupported, "got the members name");
        }

        [TestCase("{\"a\":", "no JSON"), TestCase("{[", "no JSON")]
        public void Open_BrokenJson_SaysWhere(string content, string story)
        {
            File.WriteAllText(m_path, content);
            CheckFailure(FailureCode.BadInput, story);
        }

        [Test]
        public void Open_EmptyFile_IsTruncated()
        {
            File.WriteAllBytes(m_path, new byte[0]);
            CheckFailure(FailureCode.Truncated, "0 bytes");
        }

        [Test]
        public void Open_Pipe_DoesNotWaitForAWriter()
        {
            Unix("mkfifo", m_path);
            CheckFailure(FailureCode.Truncated, "0 bytes");
        }

        [Test]
        public void Open_NoPermission_IsAccessDenied()
        {
            File.WriteAllText(m_path, "LASF");
            Unix("chmod", "000 " + m_path);
            try
            {
                File.ReadAllBytes(m_path);
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

        void CheckFailure(FailureCode code, string story)
        {
            var failure = Assert.Throws<PointCloudException>(() => PointReaders.Open(m_path).Dispose());
            Assert.That(failure.Code, Is.EqualTo(code));
            Assert.That(failure.Path, Is.EqualTo(m_path));
            Assert.That(failure.Message, Does.Contain(story).And.Not.Contain("\n"));
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
