using UnityEditor.EditorTools;
using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.SceneTools;

/// <summary>A turned cloud that is shown, for tools of the Scene view.</summary>
public abstract class SceneToolFixture : ScratchTests
{
    private protected string m_path;
    private protected CloudFolder m_folder;
    private protected World m_world;
    private protected GameObject m_scene;
    private protected PointCloud m_cloud;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_path = Scratch.Converted(points: 20_000);
        m_folder = CloudFolder.Open(m_path);
    }

    [OneTimeTearDown]
    public void DeleteCloud() => m_folder.Dispose();

    [SetUp]
    public void MakeScene()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(ScenePicking).TypeHandle);
        m_world = CloudWorld.Make();
        m_scene = new GameObject("scan");
        m_cloud = m_scene.AddComponent<PointCloud>();
        m_cloud.Path = m_path;
        CloudWorld.Turn(m_scene.transform);
        Frames(() => m_world.EntityManager.HasComponent<StreamedPointCloud>(m_cloud.Entity));
        Frames(() => true);
    }

    [TearDown]
    public void EndScene()
    {
        UnityEngine.Object.DestroyImmediate(m_scene);
        if (m_world.IsCreated)
            m_world.Dispose();
        Event.current = null;
    }

    private protected void Frames(Func<bool> isDone)
    {
        CloudWorld.Frames(m_world, isDone);
        SceneLoop.Update();
        m_world.Update();
    }

    private protected double3 WorldOf(double3 geo)
    {
        var space = m_world.EntityManager.GetComponentData<PointCloudSpace>(m_cloud.Entity).Value.FromGeo(geo);
        return new double3(100 + 2 * space.z, 50 + 2 * space.y, -30 - 2 * space.x);
    }

    private protected PointQuery Down(double east = 0)
    {
        var bounds = m_folder.Manifest.BoundsGeo;
        var above = WorldOf(new double3(bounds.Center.xy + new double2(east, 0), bounds.Max.z + 10));
        // The scan is a thin one: wide enough to hit something anywhere.
        return PointQuery.FromEye(above, new double3(0, -1, 0), 100, 100);
    }

    private protected StreamPick Find(ScenePicker picker, PointQuery ray)
    {
        Assert.That(picker.Begin(ray), Is.True);
        Frames(() => picker.Update());
        return picker.Pick;
    }

    private protected static SceneView NewView()
    {
        var view = ScriptableObject.CreateInstance<SceneView>();
        view.camera = new GameObject("camera").AddComponent<UnityEngine.Camera>();
        view.camera.targetTexture = new RenderTexture(new RenderTextureDescriptor(100, 100));
        view.camera.projectionMatrix = Matrix4x4.Perspective(60, 1, 0.1f, 1000);
        return view;
    }

    private protected static void Send(EditorTool tool, SceneView view, Event sent)
    {
        // Unity's numbers of controls are the same from event to event.
        int before = GUIUtility.LastControl;
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, () => tool.OnToolGUI(view));
        GUIUtility.LastControl = before;
        HandleUtility.nearestControl = GUIUtility.LastControl + 1;
        GUILayoutUtility.Send(sent, () => tool.OnToolGUI(view));
        GUIUtility.LastControl = before;
    }
}
