using System.Collections;
using System.IO;
using FastPoints.Editor;
using FastPoints.Store;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.Build.Reporting;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    public sealed class PlayerBuildTests : TestProjectFixture
    {
        [UnityTest, Category("Long"), Explicit("builds a whole player")]
        public IEnumerator BuildPlayer_SceneWithACloud_HasItsFolderInStreamingAssets()
        {
            var asset = TestProject.TakeScan();
            var scene = EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Single);
            PointCloudDrops.AddToScene(asset, Vector3.zero, null);
            EditorSceneManager.SaveScene(scene, TestProject.Scene);
            var deadline = TestProject.Deadline();
            while (TestProject.Awaits(TestProject.IsConverting, deadline, "the conversion"))
                yield return null;

            string folder = FileUtil.GetUniqueTempPathInProject();
            try
            {
                BuildReport report = BuildPipeline.BuildPlayer(new BuildPlayerOptions
                {
                    scenes = new[] { TestProject.Scene },
                    target = EditorUserBuildSettings.activeBuildTarget,
                    locationPathName = Path.Combine(folder, "player" + EditorUserBuildSettings.activeBuildTarget switch
                    {
                        BuildTarget.StandaloneWindows64 => ".exe",
                        BuildTarget.StandaloneOSX => ".app",
                        _ => ".x86_64",
                    }),
                });

                Assert.That(report.summary.result, Is.EqualTo(BuildResult.Succeeded));
                string[] manifests = Directory.GetFiles(folder, StoreFormat.ManifestName, SearchOption.AllDirectories);
                Assert.That(manifests, Has.Length.EqualTo(1), "clouds in the player");
                Assert.That(Path.GetDirectoryName(manifests[0]).Replace('\\', '/'),
                    Does.EndWith("StreamingAssets/" + asset.PlayerPath));
            }
            finally
            {
                if (Directory.Exists(folder))
                    Directory.Delete(folder, true);
            }
        }
    }
}
