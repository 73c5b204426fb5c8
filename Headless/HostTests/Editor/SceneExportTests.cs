using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Editor;

public sealed class SceneExportTests : EditorFixture
{
    const int Points = 20_000;

    World m_world;
    GameObject m_scene, m_box;
    PointCloud m_cloud;
    string m_source, m_folder;

    [SetUp]
    public void ShowCloud()
    {
        m_source = m_project.Scratch.Demo("scan.las", Points);
        string cloud = m_project.Scratch["scan.fastpoints"];
        Assert.That(CliCall.Of("convert", m_source, "-o", cloud, "--quiet").Status, Is.Zero);
        m_folder = Directory.CreateDirectory(m_project.Scratch["out"]).FullName;
        m_world = CloudWorld.Make();
        m_scene = new GameObject("street");
        m_cloud = m_scene.AddComponent<PointCloud>();
        m_cloud.Path = cloud;
        CloudWorld.Turn(m_scene.transform);
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
    }

    [TearDown]
    public void EndScene()
    {
        Object.DestroyImmediate(m_scene);
        if (m_box != null)
            Object.DestroyImmediate(m_box);
        m_world.Dispose();
    }

    void Frames(Func<bool> isDone)
    {
        CloudWorld.Frames(m_world, isDone);
        SceneLoop.Update();
        m_world.Update();
    }

    int Count(double3 center, double3 size)
    {
        var space = m_world.EntityManager.GetComponentData<PointCloudSpace>(m_cloud.Entity).Value;
        int inside = 0;
        using var reader = PointReaders.Open(m_source);
        var bytes = File.ReadAllBytes(m_source);
        for (int i = 0, at = (int)BitConverter.ToUInt32(bytes, 96); i < Points; i++, at += reader.Info.RecordBytes)
        {
            var place = space.FromGeo(reader.Info.Transform.ToGeo(new double3(BitConverter.ToInt32(bytes, at),
                BitConverter.ToInt32(bytes, at + 4), BitConverter.ToInt32(bytes, at + 8))));
            var world = new double3(100 + 2 * place.z, 50 + 2 * place.y, -30 - 2 * place.x);
            inside += math.all(math.abs(world - center) <= size / 2) ? 1 : 0;
        }
        return inside;
    }

    long Export()
    {
        string path = SceneExport.Begin(m_cloud, m_project.Imports, m_folder);
        Assert.That(path, Is.Not.Null, string.Join("\n", m_logged));
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => !m_project.Imports.Exports.IsExporting);
        using var reader = PointReaders.Open(path);
        return reader.PointCount;
    }

    [Test]
    public void Begin_ClipBoxOfTheScene_WritesThePointsInside([Values] bool cuts)
    {
        Assert.That(m_cloud.TryGetWorldBounds(out var bounds), Is.True);
        var center = bounds.center + new Vector3(bounds.size.x / 4, 0, 0);
        var size = new Vector3(bounds.size.x / 2, bounds.size.y + 1, bounds.size.z + 1);
        m_box = new GameObject("box");
        m_box.AddComponent<PointCloudClipBox>().Cuts = cuts;
        var place = Matrix4x4.zero;
        (place.m00, place.m11, place.m22, place.m33) = (size.x, size.y, size.z, 1);
        (place.m03, place.m13, place.m23) = (center.x, center.y, center.z);
        SceneLoop.Place(m_box.transform, place);
        Frames(() => m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream.ClipBoxes.Length == 1);

        long written = Export();

        // The scene's boxes are floats.
        var middle = new double3(center.x, center.y, center.z);
        var edges = new double3(size.x, size.y, size.z);
        int min = Count(middle, edges - 1e-3), max = Count(middle, edges + 1e-3);
        Assert.That(min, Is.GreaterThan(0).And.LessThan(Points));
        Assert.That(cuts ? Points - written : written, Is.InRange(min, max));
    }

    [Test]
    public void Begin_HiddenClasses_AreLeftOut()
    {
        long all = Export();
        Assert.That(all, Is.EqualTo(Points));
        var classes = CliCall.Of("info", "--scan", m_source, "--json", "-").Json.GetProperty("classes");
        var first = classes.EnumerateObject().First();
        m_cloud.HiddenClasses = [int.Parse(first.Name, CultureInfo.InvariantCulture)];
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
        Assert.That(Export(), Is.EqualTo(Points - first.Value.GetInt64()));
        Assert.That(Directory.GetFiles(m_folder).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "street 2.laz", "street.laz" }));
    }

    [Test]
    public void Begin_CancelledOrSuspended_LeavesNothing()
    {
        foreach (bool isCancelled in new[] { true, false })
        {
            Assert.That(SceneExport.Begin(m_cloud, m_project.Imports, m_folder), Is.Not.Null);
            m_project.Imports.Update(DateTime.UtcNow);
            if (isCancelled)
                Assert.That(Progress.Cancel(Progress.Entries.Count - 1), Is.True);
            else
                m_project.Imports.Suspend();
            Assert.That(m_project.Imports.Exports.IsExporting, Is.False);
            Assert.That(Directory.GetFiles(m_folder), Is.Empty);
        }
    }
}
