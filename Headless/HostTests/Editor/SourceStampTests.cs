using Random = System.Random;

namespace FastPoints.HostTests.Editor;

public sealed class SourceStampTests : ScratchPerTest
{
    static readonly DateTime s_then = new DateTime(2020, 1, 2, 3, 4, 5, DateTimeKind.Utc);

    string m_file;

    [SetUp]
    public void MakeFile()
    {
        m_file = Scratch["scan.las"];
        var bytes = new byte[3 * SourceStamp.EdgeBytes];
        new Random(1).NextBytes(bytes);
        File.WriteAllBytes(m_file, bytes);
        File.SetLastWriteTimeUtc(m_file, s_then);
    }

    void Flip(long offset)
    {
        using var file = new FileStream(m_file, FileMode.Open);
        file.Position = offset;
        int value = file.ReadByte();
        file.Position = offset;
        file.WriteByte((byte)(value ^ 1));
    }

    [Test]
    public void Compare_ChangedTimeWithEqualBytes_IsNoChange()
    {
        var stamp = SourceStamp.Of(new[] { m_file });
        File.SetLastWriteTimeUtc(m_file, s_then.AddYears(1));

        Assert.That(stamp.Compare(new[] { m_file }), Is.EqualTo(SourceChange.None));
    }

    [TestCase(0)]
    [TestCase(SourceStamp.EdgeBytes - 1)]
    [TestCase(2 * SourceStamp.EdgeBytes)]
    [TestCase(3 * SourceStamp.EdgeBytes - 1)]
    public void Compare_ChangedByteAtEitherEnd_IsAChange(long offset)
    {
        var stamp = SourceStamp.Of(new[] { m_file });
        Flip(offset);

        Assert.That(stamp.Compare(new[] { m_file }), Is.EqualTo(SourceChange.Changed));
    }

    [Test]
    public void Compare_ChangedSizeWithSameTime_IsAChange()
    {
        var stamp = SourceStamp.Of(new[] { m_file });
        using (var file = new FileStream(m_file, FileMode.Append))
            file.WriteByte(0);
        File.SetLastWriteTimeUtc(m_file, s_then);

        Assert.That(stamp.Compare(new[] { m_file }), Is.EqualTo(SourceChange.Changed));
    }

    [Test]
    public void Compare_MissingSource_IsMissing()
    {
        var stamp = SourceStamp.Of(new[] { m_file });
        File.Delete(m_file);

        Assert.That(stamp.Compare(new[] { m_file }), Is.EqualTo(SourceChange.Missing));
        Assert.That(() => SourceStamp.Of(new[] { m_file }),
            Throws.TypeOf<PointCloudException>().With.Property("Code").EqualTo(FailureCode.NotFound));
    }

    [Test]
    public void Compare_Folder_SeesNewAndRenamedFiles()
    {
        string folder = Scratch["tiles"];
        Directory.CreateDirectory(folder);
        File.Copy(m_file, Path.Combine(folder, "a.las"));
        File.WriteAllBytes(Path.Combine(folder, "b.las"), Array.Empty<byte>());
        var stamp = SourceStamp.Of(new[] { folder });
        Assert.That(stamp.Compare(new[] { folder }), Is.EqualTo(SourceChange.None));

        File.Move(Path.Combine(folder, "b.las"), Path.Combine(folder, "c.las"));
        Assert.That(stamp.Compare(new[] { folder }), Is.EqualTo(SourceChange.Changed));
        File.Move(Path.Combine(folder, "c.las"), Path.Combine(folder, "b.las"));
        Assert.That(stamp.Compare(new[] { folder }), Is.EqualTo(SourceChange.None));
        File.WriteAllText(Path.Combine(folder, "d.las"), "");
        Assert.That(stamp.Compare(new[] { folder }), Is.EqualTo(SourceChange.Changed));
    }
}
