namespace FastPoints.HostTests.Samples;

sealed class SampleWorld : IDisposable
{
    const int MaxFrames = 10_000_000;

    readonly List<GameObject> m_objects = new List<GameObject>();

    public SampleWorld()
    {
        World = World.DefaultGameObjectInjectionWorld = new World("sample");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(World, typeof(PointCloudSystemGroup).Assembly.GetTypes()
            .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray());
        Group = World.GetExistingSystemManaged<PointCloudSystemGroup>();
        Group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
        Application.PlayerFiles = Scratch.Root;
        SceneLoop.IsPlaying = true;
    }

    public ScratchFolder Scratch { get; } = new ScratchFolder();
    public World World { get; }
    public PointCloudSystemGroup Group { get; }

    public PointCloudAsset Asset(int points)
    {
        string path = Scratch.Converted(points: points);
        using var folder = FastPoints.Store.CloudFolder.Open(path);
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.PlayerPath = path;
        asset.BoundsMin = folder.Manifest.BoundsGeo.Min;
        asset.BoundsMax = folder.Manifest.BoundsGeo.Max;
        asset.MetresPerUnit = folder.Manifest.MetresPerUnit;
        return asset;
    }

    public T Add<T>(Action<T> set = null) where T : MonoBehaviour
    {
        var holder = new GameObject(typeof(T).Name);
        m_objects.Add(holder);
        holder.SetActive(false);
        var component = holder.AddComponent<T>();
        set?.Invoke(component);
        holder.SetActive(true);
        return component;
    }

    public void Frame()
    {
        SceneLoop.Update();
        Group.Views.Add(new StreamView { EyeWorld = new double3(0, 30, 0), ScalePx = 500 });
        World.Update();
    }

    public void Frames(Func<bool> isDone)
    {
        for (int frame = 0; frame < MaxFrames && !isDone(); frame++)
        {
            Frame();
            Thread.Yield();
        }
        Assert.That(isDone(), Is.True);
    }

    public void Settle() => Frames(() => Group.Stats.IsSettled && Group.Stats.DrawnPoints > 0 &&
        (Count<PointCloudNodesWanted>() == 0 || Count<PointCloudNode>() == Group.Stats.CachedNodes));

    public int Count<T>() where T : unmanaged, IComponentData
    {
        using var query = new EntityQueryBuilder(Allocator.Temp).WithAll<T>().Build(World.EntityManager);
        return query.CalculateEntityCount();
    }

    public void Dispose()
    {
        foreach (var holder in m_objects)
            UnityEngine.Object.DestroyImmediate(holder);
        SceneLoop.Update();
        SceneLoop.IsPlaying = false;
        World.Dispose();
        World.DefaultGameObjectInjectionWorld = null;
        Application.PlayerFiles = null;
        Scratch.Dispose();
    }
}
