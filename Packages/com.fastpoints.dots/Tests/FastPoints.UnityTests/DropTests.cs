using System.IO;
using FastPoints.Editor;
using FastPoints.Entities;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace FastPoints.UnityTests
{
    [Category("Smoke")]
    public sealed class DropTests : TestProjectFixture
    {
        int m_maxCopiedMiB;

        [SetUp]
        public void CopyNothing()
        {
            m_maxCopiedMiB = FastPointsSettings.instance.MaxCopiedMiB;
            FastPointsSettings.instance.MaxCopiedMiB = 0;
        }

        [TearDown]
        public void CopyAsBefore()
        {
            FastPointsSettings.instance.MaxCopiedMiB = m_maxCopiedMiB;
            DragAndDrop.PrepareStartDrag();
        }

        static void Drag(params string[] paths)
        {
            DragAndDrop.PrepareStartDrag();
            DragAndDrop.paths = paths;
        }

        [Test]
        public void OnProject_LargeFile_BecomesAHandleAndIsNotCopied()
        {
            string scan = TestProject.MakeScan();
            Drag(scan);

            Assert.That(PointCloudDrops.OnProject(TestProject.Folder, false), Is.EqualTo(DragAndDropVisualMode.Link));
            Assert.That(AssetDatabase.FindAssets("", new[] { TestProject.Folder }), Is.Empty, "nothing happens before the drop");
            Assert.That(PointCloudDrops.OnProject(TestProject.Folder, true), Is.EqualTo(DragAndDropVisualMode.Link));

            string handle = TestProject.Folder + "/" + Path.GetFileNameWithoutExtension(scan) + CloudHandle.Extension;
            Assert.That(AssetDatabase.LoadAssetAtPath<PointCloudAsset>(handle), Is.Not.Null);
            Assert.That(AssetDatabase.FindAssets("", new[] { TestProject.Folder }), Has.Length.EqualTo(1));
        }

        [Test]
        public void OnProject_SomethingElse_IsLeftToOthers()
        {
            string text = Path.ChangeExtension(TestProject.MakeScan(), ".md");
            File.WriteAllText(text, "no cloud");
            Drag(text);

            Assert.That(PointCloudDrops.OnProject(TestProject.Folder, true), Is.EqualTo(DragAndDropVisualMode.None));
        }

        [Test]
        public void OnScene_AssetOfACloud_CreatesAGameObjectWithUndo()
        {
            var asset = TestProject.TakeScan();
            DragAndDrop.PrepareStartDrag();
            DragAndDrop.objectReferences = new Object[] { asset };

            Assert.That(PointCloudDrops.OnScene(new Vector3(1, 2, 3), null, true), Is.EqualTo(DragAndDropVisualMode.Copy));

            var scene = GameObject.Find(asset.name);
            Assert.That(scene, Is.Not.Null);
            Assert.That(scene.GetComponent<PointCloud>().Cloud, Is.EqualTo(asset));
            Assert.That(scene.transform.position, Is.EqualTo(new Vector3(1, 2, 3)));
            Undo.PerformUndo();
            Assert.That(GameObject.Find(asset.name), Is.Null);
        }
    }
}
