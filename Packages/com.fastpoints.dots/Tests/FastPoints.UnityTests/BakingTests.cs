using System.Collections;
using FastPoints.Entities;
using NUnit.Framework;
using Unity.Scenes;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    [Category("Smoke")]
    public sealed class BakingTests : TestProjectFixture
    {
        const string SubScenePath = TestProject.Folder + "/sub.unity";

        [UnityTest]
        public IEnumerator SubScene_WithACloud_IsBakedToAnEntityWithItsFile()
        {
            var asset = TestProject.TakeScan();
            var sub = EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            new GameObject("cloud").AddComponent<PointCloudAuthoring>().Cloud = asset;
            EditorSceneManager.SaveScene(sub, SubScenePath);
            var main = EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Single);
            var reference = new GameObject("sub").AddComponent<SubScene>();
            reference.SceneAsset = AssetDatabase.LoadAssetAtPath<SceneAsset>(SubScenePath);
            reference.AutoLoadScene = true;
            EditorSceneManager.SaveScene(main, TestProject.Scene);

            yield return TestProject.EnterPlayMode();
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.CloudFiles() == 0, deadline, "the subscene"))
                yield return null;
            Assert.That(TestProject.CloudFiles(), Is.EqualTo(1));
            yield return new ExitPlayMode();
        }
    }
}
