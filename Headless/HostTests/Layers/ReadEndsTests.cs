using FastPoints.Build;
using FastPoints.Scenes;
using FastPoints.Sources;
using FastPoints.Store;
using StandIns.Io;

namespace FastPoints.HostTests.Layers;

public sealed class ReadEndsTests
{
    static readonly Regex s_wrong = new Regex(@"\bReadStatus\.InProgress\b|\bAsyncReadManager\.Read\((?!kept\.Handle\b|file\b)");

    /// <summary>A read that waits for its file to be opened is neither in progress nor ended: its JobHandle tells. A file that is
    /// read by its name stays open on macOS and Linux.</summary>
    [Test]
    public void Reads_OfThePackage_EndByTheirJobAndHaveHandles()
    {
        string root = Checkout.Repository.PackageRoot;
        var wrong = new[] { "Runtime", "Editor" }
            .SelectMany(folder => Directory.GetFiles(Path.Combine(root, folder), "*.cs", SearchOption.AllDirectories))
            .Where(path => s_wrong.IsMatch(File.ReadAllText(path))).Select(Path.GetFileName);
        Assert.That(wrong, Is.Empty);
        Assert.That(s_wrong.IsMatch("if (status == ReadStatus.InProgress)"));
        Assert.That(s_wrong.IsMatch("AsyncReadManager.Read(path, commands, 1)"));
    }

    [Test]
    public void Frames_WhileFilesAreBeingOpened_LoseNothing()
    {
        string folder = Directory.CreateTempSubdirectory("fastpoints-").FullName;
        try
        {
            string las = Path.Combine(folder, "a.las"), cloud = Path.Combine(folder, "a.fastpoints");
            JobCoroutine.RunToEnd(LasScan.Run(las, 50_000, 1, ScanOrder.Strip, null));
            using (var reader = PointReaders.Open(las))
                JobCoroutine.RunToEnd(ConvertCloud.Run([reader], cloud, new ConvertSettings(), _ => { }, null));
            using var stream = new StreamContext(new MemoryNodePool(64 << 20, 1 << 20));
            stream.Settings.MaxTries = 1;
            var source = new FolderSource(CloudFolder.Open(cloud));
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            using var views = new NativeArray<StreamView>(1, Allocator.Persistent)
            {
                [0] = StreamView.Everything(1),
            };
            IoThreads.Pause(true);
            // A frame that waits for a read would wait for ever.
            using var end = new System.Threading.Timer(_ => IoThreads.Pause(false), null, 5000, -1);
            int underWay = 0;
            try
            {
                for (int frame = 0; frame < 5; frame++)
                    underWay = FrameStep.Run(stream, views).ReadsInFlight;
            }
            finally
            {
                IoThreads.Pause(false);
            }
            Assert.That(underWay, Is.GreaterThan(0));
            for (int frame = 0; frame < 100_000 && !FrameStep.Run(stream, views).IsSettled; frame++)
                System.Threading.Thread.Yield();
            Assert.That(stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
            Assert.That(stream.Drawn.Length, Is.GreaterThan(0));
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }
}
