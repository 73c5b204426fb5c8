using System.Collections;
using System.IO;
using FastPoints.Editor;
using FastPoints.Entities;
using FastPoints.Store;
using NUnit.Framework;
using UnityEditor;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    [Category("Smoke")]
    public sealed class ImporterTests : TestProjectFixture
    {
        [UnityTest]
        public IEnumerator PointFile_InAssets_GetsOurImporterIfNoOtherClaimsIt()
        {
            string asset = TestProject.Folder + "/hills.las";
            File.Copy(TestProject.MakeScan(), asset);
            AssetDatabase.Refresh();
            TestProject.Claim(asset);
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset) == null, deadline,
                "the import of " + asset))
                yield return null;

            Assert.That(AssetDatabase.GetImporterType(asset), Is.EqualTo(typeof(PointFileImporter)));
            Assert.That(AssetDatabase.GetImporterOverride(asset), Is.EqualTo(typeof(PointFileImporter)));
            while (TestProject.Awaits(TestProject.IsConverting, deadline, "the conversion of " + asset))
                yield return null;
            var cloud = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset);
            Assert.That(Path.Combine(TestProject.ConvertedFolder(cloud), StoreFormat.ManifestName), Does.Exist);
        }

        [UnityTest]
        public IEnumerator Handle_OfAFileOutside_KnowsItsPointsWhenItIsConverted()
        {
            const int Points = 30_000;
            string path = AssetDatabase.GetAssetPath(TestProject.TakeScan(Points));
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.IsConverting, deadline, "the conversion of " + path))
                yield return null;

            Assert.That(AssetDatabase.GetImporterType(path), Is.EqualTo(typeof(HandleImporter)));
            var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(path);
            Assert.That(asset.Points, Is.EqualTo(Points));
            Assert.That(asset.BoundsMax.x, Is.GreaterThan(asset.BoundsMin.x));
            Assert.That(Path.Combine(TestProject.ConvertedFolder(asset), StoreFormat.ManifestName), Does.Exist);
        }
    }
}
