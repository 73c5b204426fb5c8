namespace FastPoints.HostTests.Editor;

public sealed class ThumbnailTests : EditorFixture
{
    CloudThumbnails Thumbnails => m_project.Imports.Thumbnails;

    string PictureOf(PointCloudAsset asset) => CloudThumbnails.PathOf(m_project.Paths.Absolute(asset.ProjectPath));

    void Draw()
    {
        ImportProject.Updates(() => Thumbnails.Update(1), () => !Thumbnails.IsDrawing);
        m_project.Imports.ShowThumbnails();
    }

    static void AssertShowsSomething(RgbaImage picture)
    {
        Assert.That((picture.Width, picture.Height), Is.EqualTo((ThumbnailDrawing.SizePx, ThumbnailDrawing.SizePx)));
        Assert.That(picture.Rgba.Distinct().Count(), Is.GreaterThan(50), "there is something in it");
    }

    [Test]
    public void Thumbnail_OfAFile_IsReplacedByTheConvertedCloudsOne()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 200_000), "Assets");
        Draw();
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(1), "it is not converted yet");
        var first = Png.Read(PictureOf(asset));
        AssertShowsSomething(first);

        m_project.UpdateToTheEnd();
        Draw();

        var second = Png.Read(PictureOf(asset));
        AssertShowsSomething(second);
        Assert.That(second.Rgba, Is.Not.EqualTo(first.Rgba));
        Assert.That(ImageError.Compare(first, second, new PictureOptions().Background).Psnr,
            Is.GreaterThan(10), "they show the same");
        Assert.That(m_logged, Is.Empty);
        CloudCatalog.Delete(m_project.Paths.Absolute(asset.ProjectPath));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(m_project.Paths.Clouds),
            Is.EqualTo(new[] { Path.Combine(m_project.Paths.Clouds, ".gitignore") }), "it goes with the converted data");
    }

    [TestCase("samples/copc/lone-star.copc.laz")]
    [TestCase("samples/ept")]
    [TestCase("samples/potree")]
    [TestCase("samples/laz/MixedConifer.laz")]
    [TestCase("ca13_d.laz")]
    [TestCase("lion.laz")]
    public void Thumbnail_OfARealCloudThatIsNotConverted_IsOfItsFirstWave(string name)
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        var watch = Stopwatch.StartNew();
        var asset = m_project.Imports.CreateAsset(Real(name), "Assets");
        double longest = 0;
        var update = new Stopwatch();
        ImportProject.Updates(() =>
        {
            update.Restart();
            Thumbnails.Update(1);
            longest = Math.Max(longest, update.Elapsed.TotalMilliseconds);
        }, () => !Thumbnails.IsDrawing);
        TestContext.Progress.WriteLine($"{name}: {watch.Elapsed.TotalSeconds:F2} s, longest update {longest:F1} ms");
        AssertShowsSomething(Png.Read(PictureOf(asset)));
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        Assert.That(m_logged, Is.Empty);
    }

    static string Real(string name)
    {
        string path = TestData.PathOrIgnore("data/" + name);
        return File.Exists(path) ? path : Directory.GetDirectories(path).Order().First(CloudSources.IsCloud);
    }

    [Test]
    public void Thumbnail_OfAFolderOfTiles_IsOfAllOfThem()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        Directory.CreateDirectory(m_project.Scratch["tiles"]);
        m_project.Scratch.Demo("tiles/a.las", 20_000);
        m_project.Scratch.Demo("tiles/b.las", 10_000);
        var asset = m_project.Imports.CreateAsset(m_project.Scratch["tiles"], "Assets");
        Draw();
        AssertShowsSomething(Png.Read(PictureOf(asset)));
    }

    [Test]
    public void Thumbnail_FileInAssetsImportedAgain_IsDrawnOnce()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        m_project.Scratch.Demo("project/Assets/scan.las", 5000);
        int imports = 0;
        AssetDatabase.Refresh();
        ScriptedImports.Configure = _ => imports++;
        Draw();
        AssertShowsSomething(Png.Read(PictureOf(m_project.Asset("Assets/scan.las"))));
        Assert.That(imports, Is.GreaterThan(0), "once more for its picture");
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
    }

    [Test]
    public void Thumbnail_OfAFileWhoseImportIsPaused_LeavesItPaused()
    {
        m_project.Scratch.Demo("project/Assets/scan.las", 5000);
        AssetDatabase.Refresh();
        var request = m_project.Imports.Queue.Requests.Single();
        m_project.Imports.Queue.Pause(request);
        Draw();
        Assert.That(m_project.Imports.Queue.Requests.Single(), Is.SameAs(request));
        Assert.That(request.State, Is.EqualTo(ImportState.Paused));
    }

    [Test]
    public void Thumbnail_UnexpectedException_IsReportedOnceAndTheNextIsDrawn()
    {
        string scan = m_project.Scratch.Demo("scan.las", 5000);
        string first = m_project.Scratch["first.fastpoints"], second = m_project.Scratch["second.fastpoints"];
        Thumbnails.Drawn += cloud =>
        {
            if (cloud == first)
                throw new InvalidOperationException("planted");
        };
        Thumbnails.AddFiles(first, new[] { scan });
        Thumbnails.AddFiles(second, new[] { scan });
        Draw();
        Assert.That(m_logged, Has.Count.EqualTo(1));
        Assert.That(m_logged[0], Does.StartWith("Error: FastPoints: no picture of " + first
            + ": InvalidOperationException: planted\n").And.Contains(nameof(ThumbnailTests)));
        AssertShowsSomething(Png.Read(CloudThumbnails.PathOf(second)));
    }

    [Test]
    public void Thumbnail_OfAFileWhoseImportWasCancelled_DoesNotBeginItAgain()
    {
        m_project.Scratch.Demo("project/Assets/scan.las", 5000);
        AssetDatabase.Refresh();
        m_project.Imports.Queue.Cancel(m_project.Imports.Queue.Requests.Single());
        Draw();
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
    }

    [Test]
    public void Thumbnail_OfAnUnreadableFile_IsMissingWithoutAReport()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Copc("scan.copc.laz"), "Assets");
        Draw();
        Assert.That(File.Exists(PictureOf(asset)), Is.False);
        Assert.That(m_logged, Is.Empty, "what opens the cloud tells");
    }

    [Test]
    public void Dispose_InTheMiddle_LeavesNothingOpen()
    {
        string source = m_project.Scratch.Demo("scan.las", 100_000);
        for (int updates = 0; updates < 20; updates++)
        {
            using var thumbnails = new CloudThumbnails();
            thumbnails.AddFiles(m_project.Paths.Absolute("PointClouds/scan.fastpoints"), new[] { source });
            for (int i = 0; i < updates; i++)
                thumbnails.Update(1);
            thumbnails.Dispose();
            Assert.That(thumbnails.IsDrawing, Is.False);
        }
    }

    [Test]
    public void CreateAsset_TwoUnconvertedFilesOfOneName_HaveAThumbnailEach()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        Directory.CreateDirectory(m_project.Scratch["other"]);
        var first = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 3000), "Assets");
        var second = m_project.Imports.CreateAsset(m_project.Scratch.Demo("other/scan.las", 4000), "Assets");
        Assert.That(second.ProjectPath, Is.EqualTo("PointClouds/scan 2.fastpoints"));
        Draw();
        AssertShowsSomething(Png.Read(PictureOf(first)));
        AssertShowsSomething(Png.Read(PictureOf(second)));
    }

    [Test]
    public void Thumbnail_OfAConvertedCloud_IsDrawnAndShown()
    {
        var asset = m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 20_000), "Assets");
        m_project.UpdateToTheEnd();
        Draw();

        string cloud = m_project.Paths.Absolute(asset.ProjectPath);
        AssertShowsSomething(Png.Read(PictureOf(asset)));

        var editor = ScriptableObject.CreateInstance<PointCloudAssetEditor>();
        editor.target = asset;
        var texture = editor.RenderStaticPreview("Assets/scan.pointcloud", null, 64, 32);
        Assert.That((texture.width, texture.height), Is.EqualTo((64, 32)));
        Assert.That(texture.Bytes.Distinct().Count(), Is.GreaterThan(50));
        var same = editor.RenderStaticPreview("Assets/scan.pointcloud", null, ThumbnailDrawing.SizePx, ThumbnailDrawing.SizePx);
        Assert.That(same.Bytes, Is.EqualTo(Png.Read(PictureOf(asset)).RgbaFromBottom()),
            "the lowest row of a texture is the first");
        File.WriteAllText(CloudThumbnails.PathOf(cloud), "no picture");
        Assert.That(editor.RenderStaticPreview("Assets/scan.pointcloud", null, 64, 32), Is.Null);
        Directory.Delete(cloud, true);
        Thumbnails.Add(cloud);
        Draw();
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void Resized_Picture_AveragesPixelsBottomUp()
    {
        var image = new RgbaImage(4, 2);
        for (int x = 0; x < 4; x++)
            for (int y = 0; y < 2; y++)
                image[x, y] = Palettes.Pack((byte)(x * 10), (byte)(y * 100), 7, 255);
        var texture = new Texture2D(4, 2, TextureFormat.RGBA32, false);
        texture.SetPixelData(image.RgbaFromBottom(), 0);
        Assert.That(ThumbnailImage.Resized(texture, 2, 2), Is.EqualTo(new byte[]
        {
            5, 100, 7, 255, 25, 100, 7, 255,
            5, 0, 7, 255, 25, 0, 7, 255,
        }));
        Assert.That(ThumbnailImage.Resized(texture, 8, 1).Length, Is.EqualTo(32), "larger ones repeat");
    }
}
