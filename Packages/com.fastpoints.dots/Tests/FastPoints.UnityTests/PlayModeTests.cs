using System.Collections;
using FastPoints.Editor;
using FastPoints.Entities;
using FastPoints.Rendering;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    [Category("Smoke")]
    public sealed class PlayModeTests : TestProjectFixture
    {
        const string CloudName = "the tests' cloud";

        [UnityTest]
        public IEnumerator PlayMode_CloudInTheScene_IsStreamedForTheCamera()
        {
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null || GraphicsNodePool.UnsupportedReason != null)
                Assert.Ignore(GraphicsNodePool.UnsupportedReason ?? "without a graphics device no camera draws");
            // The usual camera looks along Z from ten metres before the cloud.
            var scene = EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Single);
            PointCloudDrops.AddToScene(TestProject.TakeScan(), Vector3.zero, null).gameObject.name = CloudName;
            EditorSceneManager.SaveScene(scene, TestProject.Scene);
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.IsConverting, deadline, "the conversion"))
                yield return null;

            yield return TestProject.EnterPlayMode();
            deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.DrawnNodes() == 0, deadline, "the first drawn node"))
            {
                TestProject.Draw();
                yield return null;
            }
            while (TestProject.Awaits(PointScene.Current.RecordedPictures == 0, deadline,
                "the first picture that the pass of the project's pipeline records"))
            {
                TestProject.Draw();
                yield return null;
            }
            yield return new ExitPlayMode();

            Assert.That(EditorApplication.isPlaying, Is.False);
            Assert.That(GameObject.Find(CloudName), Is.Not.Null, "the scene is as it was");
        }

        [UnityTest]
        public IEnumerator PlayMode_DuringAConversion_LosesNothing()
        {
            const int Points = 2_000_000;
            TestProject.TakeScan(Points);
            Assert.That(TestProject.IsConverting, Is.True, "begun, in batch mode too");
            yield return null;

            yield return TestProject.EnterPlayMode();
            yield return null;
            yield return new ExitPlayMode();
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.IsConverting, deadline, "the conversion"))
                yield return null;

            string[] made = AssetDatabase.FindAssets("t:" + nameof(PointCloudAsset), new[] { TestProject.Folder });
            Assert.That(made, Has.Length.EqualTo(1));
            Assert.That(AssetDatabase.LoadAssetAtPath<PointCloudAsset>(AssetDatabase.GUIDToAssetPath(made[0])).Points,
                Is.EqualTo(Points));
        }
    }
}
