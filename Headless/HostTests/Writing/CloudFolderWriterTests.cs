namespace FastPoints.HostTests.Writing;

public sealed class CloudFolderWriterTests : ScratchPerTest
{
    string m_target;
    string m_part;
    string m_lock;

    [SetUp]
    public void NamePaths()
    {
        m_target = Scratch["cloud.fastpoints"];
        m_part = m_target + StoreFormat.UnfinishedSuffix;
        m_lock = Path.Combine(m_part, "build.lock");
    }

    [Test]
    public void Create_FolderLockedByAnotherWriter_IsRefusedAndChangesNothing()
    {
        using (var first = new CloudFolderWriter(m_target))
        {
            Assert.That(() => new CloudFolderWriter(m_target), Throws.TypeOf<PointCloudException>().With.Message.EndsWith(
                "is being built by process " + Environment.ProcessId + " on " + Environment.MachineName));
            CloudFolderWriter.DeleteUnfinished(m_target);
            Assert.That(File.Exists(m_lock), Is.True);
            JobCoroutine.RunToEnd(first.Complete());
        }
        Assert.That(Directory.Exists(m_part), Is.False);
        Assert.That(File.Exists(Path.Combine(m_target, "build.lock")), Is.False);
    }

    [Test]
    public void DeleteUnfinished_KeptFolder_LeavesNothing()
    {
        var writer = new CloudFolderWriter(m_target);
        writer.Keep();
        writer.Dispose();
        Assert.That(Directory.Exists(m_part), Is.True);
        Assert.That(File.Exists(m_lock), Is.False);
        CloudFolderWriter.DeleteUnfinished(m_target);
        Assert.That(Directory.Exists(m_part), Is.False);
    }

    [Test]
    public void Complete_LockTakenByAnotherProcess_FailsAndLeavesTheFolder()
    {
        var writer = new CloudFolderWriter(m_target);
        File.WriteAllText(m_lock, "far\n7\n1\nanother load\n");
        Assert.That(() => JobCoroutine.RunToEnd(writer.Complete()),
            Throws.TypeOf<PointCloudException>().With.Message.EndsWith("was taken over by another process"));
        writer.Dispose();
        Assert.That(File.Exists(m_lock), Is.True);
        Assert.That(Directory.Exists(m_target), Is.False);
    }
}
