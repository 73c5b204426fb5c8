namespace FastPoints.HostTests;

static class CloudWorld
{
    const int MaxFrames = 10_000_000; // Folders are opened on another thread, which may get its turn late on a machine at work.

    public static World Make()
    {
        var world = World.DefaultGameObjectInjectionWorld = new World("default");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, typeof(PointCloudSystemGroup),
            typeof(OpenCloudsSystem), typeof(PlaceCloudsSystem), typeof(AddCloudsSystem), typeof(ClipCloudsSystem));
        world.GetExistingSystemManaged<PointCloudSystemGroup>().Begin(new MemoryNodePool(1 << 24, 1 << 20));
        return world;
    }

    public static void Turn(Transform transform)
    {
        var matrix = Matrix4x4.zero;
        (matrix.m02, matrix.m11, matrix.m20, matrix.m33) = (2, 2, -2, 1);
        (matrix.m03, matrix.m13, matrix.m23) = (100, 50, -30);
        SceneLoop.Place(transform, matrix);
    }

    public static void Frames(World world, Func<bool> isDone)
    {
        for (int frame = 0; frame < MaxFrames && !isDone(); frame++)
        {
            SceneLoop.Update();
            world.Update();
            EditorApplication.update?.Invoke();
            Thread.Yield();
        }
        Assert.That(isDone(), Is.True);
    }
}
