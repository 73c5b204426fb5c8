namespace FastPoints.HostTests.Editor;

public sealed class PointFileClaimTests : EditorFixture
{
    [SetUp]
    public void DisablePrompts()
    {
        EditorUtility.s_agrees = false;
        EditorUtility.s_dialogs.Clear();
        SessionState.EraseString("FastPoints.PointFilePrompt");
        FastPointsSettings.instance.PointFiles = PointFiles.Ask;
    }

    void Update() => m_project.Imports.Update(DateTime.UtcNow);

    [TestCase(true)]
    [TestCase(false)]
    public void File_OfAProjectThatWasNotAsked_WaitsForTheAnswer(bool agrees)
    {
        EditorUtility.s_agrees = agrees;
        m_project.Scratch.Demo("project/Assets/one.las", 500);
        AssetDatabase.Refresh();
        Assert.That(m_project.Asset("Assets/one.las"), Is.Null, "nobody has agreed");
        Assert.That(EditorUtility.s_dialogs, Is.Empty, "not while Unity imports");
        Update();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1));
        Assert.That(m_project.Asset("Assets/one.las") != null, Is.EqualTo(agrees));
        Assert.That(File.ReadAllText("ProjectSettings/FastPoints.asset"),
            Does.Contain("PointFiles: " + (agrees ? "Import" : "Leave")));

        m_project.Scratch.Demo("project/Assets/two.las", 500);
        AssetDatabase.Refresh();
        Update();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1), "asked once");
        Assert.That(m_project.Asset("Assets/two.las") != null, Is.EqualTo(agrees));
    }

    /// <summary>A file from before the package was imported by Unity's own importer, and no event reports it again.</summary>
    [Test]
    public void File_OlderThanThePackage_IsImportedAlike()
    {
        FastPointsSettings.instance.PointFiles = PointFiles.Leave;
        m_project.Scratch.Demo("project/Assets/one.las", 500);
        AssetDatabase.Refresh();
        Update();
        Assert.That(m_project.Asset("Assets/one.las"), Is.Null);
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
        Update();
        Assert.That(m_project.Asset("Assets/one.las"), Is.Not.Null);
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
    }

    [TestCase("Assets/StreamingAssets/a.las", null)]
    [TestCase("Assets/Editor Default Resources/a.las", null)]
    [TestCase("Assets/mesh.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nend_header\n")]
    [TestCase("Assets/strips.ply", "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nelement tristrips 1\r\nend_header\r\n")]
    public void File_NotACloudOfTheProject_IsIgnored(string path, string text)
    {
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
        Directory.CreateDirectory(Path.GetDirectoryName(path));
        if (text == null)
            m_project.Scratch.Demo("project/" + path, 100);
        else
            File.WriteAllText(path, text);
        AssetDatabase.Refresh();
        Update();
        Assert.That(AssetDatabase.GetImporterOverride(path), Is.Null);
    }

    [Test]
    public void Ply_WithoutFaces_IsImported()
    {
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
        File.WriteAllText("Assets/points.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n" +
            "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n");
        AssetDatabase.Refresh();
        Assert.That(AssetDatabase.GetImporterOverride("Assets/points.ply"), Is.EqualTo(typeof(PointFileImporter)));
    }

    [Test]
    public void Cancel_ByTheUser_LastsUntilTheUserConverts()
    {
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
        m_project.Scratch.Demo("project/Assets/one.las", 500);
        AssetDatabase.Refresh();
        m_project.Imports.Cancel(m_project.Imports.RequestOf("Assets/one.las"));
        AssetDatabase.ImportAsset("Assets/one.las", ImportAssetOptions.ForceUpdate);
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);

        m_project.Imports.Convert("Assets/one.las");
        m_project.UpdateToTheEnd();
        Assert.That(CloudFolder.IsCloud(m_project.Paths.Absolute(m_project.Imports.HandleOf("Assets/one.las").CloudPath)));
    }

    [TestCase("PointClouds")]
    [TestCase("Else where")]
    public void Preview_InAWorker_FindsThePicture(string place)
    {
        FastPointsSettings.instance.PointFiles = PointFiles.Import;
        Assert.That(PointCloudImports.SwitchConvertedRoot(place), Is.Null);
        FastPointsSettings.instance.Save();
        m_project.Scratch.Demo("project/Assets/one.las", 500);
        AssetDatabase.Refresh();
        ImportProject.Updates(Update, () => !m_project.Imports.Thumbnails.IsDrawing);
        var editor = UnityEditor.Editor.Of<PointCloudAssetEditor>(m_project.Asset("Assets/one.las"));
        AssetDatabase.s_previewing = true;
        try
        {
            Assert.That(editor.RenderStaticPreview("Assets/one.las", null, 32, 32), Is.Not.Null);
        }
        finally
        {
            AssetDatabase.s_previewing = false;
            UnityEngine.Object.DestroyImmediate(editor);
        }
    }
}
