namespace FastPoints.HostTests.Layers;

public sealed class SlotFilesTests
{
    static readonly Regex s_slot = new Regex(@"\bclass \w+ : (BlockRead|OwningBlockRead|StridedRead|NodeRead|PlyRead)\b");
    static readonly Regex s_managedFile = new Regex(
        @"\b(RandomAccessFile|FileInfo|FileStream|Directory|LasReader\.Open|System\.IO)\b");

    [Test]
    public void Slots_OfAllReaders_OpenNoFiles()
    {
        string files = Path.Combine(Checkout.Repository.PackageRoot, "Runtime", "FastPoints.Import");
        // A slot is the last type of its file, and may stand behind its reader.
        var slots = Directory.GetFiles(files, "*.cs", SearchOption.AllDirectories)
            .Select(path => (Name: Path.GetFileName(path), Text: File.ReadAllText(path)))
            .Where(file => s_slot.IsMatch(file.Text))
            .Select(file => (file.Name, Text: file.Text[s_slot.Match(file.Text).Index..])).ToArray();

        Assert.That(slots.Select(slot => slot.Name), Is.SupersetOf(new[] { "LazBlockRead.cs", "NodeRead.cs", "EptRecordRead.cs",
            "PotreeRecordRead.cs", "PotreeBrotliRead.cs" }));
        Assert.That(slots.Where(slot => s_managedFile.IsMatch(slot.Text)).Select(slot => slot.Name), Is.Empty);
    }
}
