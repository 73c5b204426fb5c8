using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Remote;

sealed class RemoteColliderTests : RemoteFixture
{
    [Test]
    public void LateUpdate_ServerThatGoes_KeepsTheGroundAndSaysSoOnce()
    {
        FastPoints.HostTests.Surface.PointCloudColliderTests.Convert(Scratch["served/ground.fastpoints"]);
        // What was read ahead would still be there.
        RemoteAccess.CacheBytes = 0;
        string address = Server.Of("ground.fastpoints");
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        using var world = new SampleWorld();
        var player = new GameObject("player").transform;
        try
        {
            player.position = new Vector3(-28, 1, 0);
            var collider = world.Add<PointCloudCollider>(added =>
            {
                added.GetComponent<PointCloud>().Path = address + Secret;
                added.Followed.Add(player);
                (added.Radius, added.VoxelSize, added.FrameMs, added.CacheMegabytes) = (4, 0.2f, 4, 0);
            });
            world.Frames(() => collider.IsReady(player.position, 1) || collider.Error != null);
            Assert.That(collider.Error, Is.Null);
            Assert.That(collider.TriangleCount, Is.Positive);
            long triangles = collider.TriangleCount;
            Server.Dispose();
            player.position = new Vector3(28, 1, 0);
            world.Frames(() => collider.Error != null);
            world.Frame();
            Assert.That(collider.Error, Does.StartWith(address).And.Not.Contain("secret"));
            Assert.That(logged.Count(l => l.Contains("lacks colliders")), Is.EqualTo(1));
            Assert.That(collider.TriangleCount, Is.EqualTo(triangles));
        }
        finally
        {
            Object.DestroyImmediate(player.gameObject);
            Debug.s_sink = null;
        }
    }
}
