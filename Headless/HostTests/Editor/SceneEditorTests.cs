using UnityEditor.IMGUI.Controls;
using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Editor;

public sealed class SceneEditorTests
{
    static Bounds? FrameBounds(UnityEditor.Editor editor)
    {
        const BindingFlags Any = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance |
            BindingFlags.FlattenHierarchy;
        bool hasBounds = (bool)editor.GetType().GetMethod("HasFrameBounds", Any).Invoke(editor, null);
        return hasBounds ? (Bounds)editor.GetType().GetMethod("OnGetFrameBounds", Any).Invoke(editor, null) : null;
    }

    static Matrix4x4 Turned(float scale, Vector3 place)
    {
        var matrix = Matrix4x4.zero;
        (matrix.m02, matrix.m11, matrix.m20, matrix.m33) = (scale, scale, -scale, 1);
        (matrix.m03, matrix.m13, matrix.m23) = (place.x, place.y, place.z);
        return matrix;
    }

    [Test]
    public void Frame_RotatedCloudKnownByItsAsset_IsItsBox()
    {
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<PointCloud>();
        var editor = ScriptableObject.CreateInstance<PointCloudEditor>();
        editor.target = cloud;
        Assert.That(FrameBounds(editor), Is.Null, "nothing is known");
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.BoundsMin = new double3(690_000, 5_330_000, 500);
        asset.BoundsMax = new double3(690_100, 5_330_040, 520);
        asset.MetresPerUnit = 0.5;
        cloud.Cloud = asset;
        SceneLoop.Place(scene.transform, Turned(2, new Vector3(10, 20, 30)));

        var bounds = FrameBounds(editor).Value;

        // 100 x 40 x 20 units of half a metre, twice as large: north is forward, and forward is turned to the right.
        Assert.That(bounds.size, Is.EqualTo(new Vector3(40, 20, 100)));
        Assert.That(bounds.center, Is.EqualTo(new Vector3(10, 30, 30)), "it stands on its middle");
        Object.DestroyImmediate(scene);
    }

    [TestCase("m_color", ColorMode.Elevation)]
    [TestCase("m_colorRamp", FastPoints.Drawing.ColorRamp.Gray)]
    [TestCase("m_hiddenClasses", new[] { 2, 7 })]
    [TestCase("m_path", "elsewhere.fastpoints")]
    public void Update_RestoredField_ReopensTheCloudOnce(string field, object value)
    {
        using var world = World.DefaultGameObjectInjectionWorld = new World("default");
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<PointCloud>();
        cloud.Path = "scan.fastpoints";
        var before = cloud.Entity;
        SceneLoop.Update();
        Assert.That(cloud.Entity, Is.EqualTo(before));

        typeof(PointCloud).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(cloud, value);
        SceneLoop.Update();

        Assert.That(cloud.Entity, Is.Not.EqualTo(before));
        var file = world.EntityManager.GetComponentData<PointCloudFile>(cloud.Entity);
        Assert.That(
            PointCloudPaths.Of(PointCloudPaths.BytesOf(world.EntityManager.GetBuffer<PointCloudPathByte>(cloud.Entity))).Path,
            Is.EqualTo(cloud.Path));
        Assert.That((file.Color, file.ColorRamp), Is.EqualTo((cloud.Color, cloud.ColorRamp)));
        Assert.That(file.HiddenClasses, Is.EqualTo(ClassMask.Of(cloud.HiddenClasses)));
        var after = cloud.Entity;
        SceneLoop.Update();
        Assert.That(cloud.Entity, Is.EqualTo(after));
        Object.DestroyImmediate(scene);
    }

    [Test]
    public void Undo_OfAProperty_RestoresTheFieldAndTheCloud()
    {
        using var world = World.DefaultGameObjectInjectionWorld = new World("default");
        var scene = new GameObject("scan");
        var cloud = scene.AddComponent<PointCloud>();
        cloud.Path = "scan.fastpoints";
        Undo.RecordObject(cloud, "Show classes");
        cloud.HiddenClasses = new[] { 2 };
        var hiding = cloud.Entity;

        Undo.PerformUndo();
        Assert.That(cloud.HiddenClasses, Is.Empty);
        Assert.That(cloud.Entity, Is.EqualTo(hiding), "nobody has told it");
        SceneLoop.Update();

        Assert.That(cloud.Entity, Is.Not.EqualTo(hiding));
        Assert.That(world.EntityManager.GetComponentData<PointCloudFile>(cloud.Entity).HiddenClasses.IsEmpty, Is.True);
        Object.DestroyImmediate(scene);
    }

    [Test]
    public void Frame_ClipBox_IsItself()
    {
        var scene = new GameObject("box");
        var editor = ScriptableObject.CreateInstance<ClipBoxEditor>();
        editor.target = scene.AddComponent<PointCloudClipBox>();
        SceneLoop.Place(scene.transform, Turned(4, new Vector3(1, 2, 3)));
        Assert.That(FrameBounds(editor).Value, Is.EqualTo(new Bounds(new Vector3(1, 2, 3), new Vector3(4, 4, 4))));
        Object.DestroyImmediate(scene);
    }

    [Test]
    public void Apply_DraggedSide_MovesAndScalesTheBox()
    {
        var scene = new GameObject("box");
        scene.transform.localScale = new Vector3(4, 4, 4);
        SceneLoop.Place(scene.transform, Turned(4, new Vector3(1, 2, 3)));

        var editor = ScriptableObject.CreateInstance<ClipBoxEditor>();
        editor.target = scene.AddComponent<PointCloudClipBox>();
        GUIUtility.hotControl = 0;
        var draw = typeof(ClipBoxEditor).GetMethod("OnSceneGUI", BindingFlags.Instance | BindingFlags.NonPublic);
        void Drag(params float?[] ways)
        {
            foreach (float? way in ways)
            {
                PrimitiveBoundsHandle.Way = way;
                draw.Invoke(editor, null);
            }
        }

        // Its right side, which shows backwards in the world, by half an edge outwards, in several events.
        Drag(0, 0.5f, 1, 1.5f, 1.5f, 2, null);

        Assert.That((scene.transform.position - new Vector3(1, 2, 2)).magnitude, Is.LessThan(1e-5));
        Assert.That((scene.transform.localScale - new Vector3(6, 4, 4)).magnitude, Is.LessThan(1e-5));
        Drag(0, -6, null);
        Assert.That(scene.transform.localScale.x, Is.GreaterThan(0), "a flat box could not be opened again");
        Object.DestroyImmediate(scene);
    }
}
