using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Benchmarks;
using FastPoints.Editor;
using FastPoints.Entities;
using NUnit.Framework;
using Unity.Entities;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    public static class TestProject
    {
        public const string Folder = "Assets/FastPointsUnityTests";
        public const string Scene = Folder + "/main.unity";
        const string PointFilesBefore = "FastPoints.UnityTests.PointFiles";
        const double PatienceSeconds = 120; // How long a test waits for something that takes a second or two.

        static string Outside => Path.Combine(Path.GetTempPath(), "fastpoints-unity-tests");

        static EditorImports Imports => PointCloudImports.Current;

        public static bool IsConverting
        {
            get
            {
                // In batch mode nothing is converted by itself.
                if (Application.isBatchMode)
                    Imports.Update(DateTime.UtcNow);
                foreach (var request in Imports.Queue.Requests)
                    Assert.That(request.State, Is.Not.EqualTo(ImportState.Failed), request.Failure);
                return Imports.Queue.Requests.Count > 0;
            }
        }

        public static void Begin()
        {
            Clean();
            // Otherwise the user's own files would be claimed, in their .meta files.
            SessionState.SetInt(PointFilesBefore, (int)FastPointsSettings.instance.PointFiles);
            FastPointsSettings.instance.PointFiles = PointFiles.Leave;
            Directory.CreateDirectory(Outside);
            AssetDatabase.CreateFolder(Path.GetDirectoryName(Folder), Path.GetFileName(Folder));
        }

        /// <summary>Takes everything away, an empty scene included; also what an earlier run left.</summary>
        public static void Clean()
        {
            int before = SessionState.GetInt(PointFilesBefore, -1);
            if (before >= 0)
                FastPointsSettings.instance.PointFiles = (PointFiles)before;
            SessionState.EraseInt(PointFilesBefore);
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            foreach (var request in new List<ImportRequest>(Imports.Queue.Requests))
                if (AssetDatabase.GUIDToAssetPath(request.AssetGuid).StartsWith(Folder, StringComparison.Ordinal))
                    Imports.Queue.Cancel(request);
            if (AssetDatabase.IsValidFolder(Folder))
            {
                foreach (string file in Directory.GetFiles(Imports.Paths.Absolute(Folder)))
                    DeleteConverted(Imports.Paths.Stored(file));
                AssetDatabase.DeleteAsset(Folder);
            }
            if (Directory.Exists(Outside))
                Directory.Delete(Outside, true);
        }

        /// <summary>A seeded LAS file of hills outside of the project, about a twelfth of a metre between its points.</summary>
        public static string MakeScan(int points = 20_000) =>
            TerrainBenchmarkFile.Make(new WorkloadContext { ScratchFolder = Outside, Points = points });

        public static PointCloudAsset TakeScan(int points = 20_000)
        {
            var asset = Imports.CreateAsset(MakeScan(points), Folder);
            Assert.That(asset, Is.Not.Null, "the Console says why");
            return asset;
        }

        /// <summary>The folder of an asset's converted cloud; it may not be there.</summary>
        public static string ConvertedFolder(PointCloudAsset asset) => Imports.Paths.Absolute(asset.ProjectPath);

        /// <summary>Has a file of the tests' folder imported as it would be in a project that wants that.</summary>
        public static void Claim(string asset)
        {
            var settings = FastPointsSettings.instance;
            settings.PointFiles = PointFiles.Import;
            try
            {
                new PointFilePrompt(settings).Add(new List<string> { asset });
            }
            finally
            {
                settings.PointFiles = PointFiles.Leave;
            }
        }

        public static void Draw()
        {
            var camera = Camera.main;
            if (camera.targetTexture == null)
                camera.targetTexture = new RenderTexture(320, 180, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
            camera.Render();
        }

        public static DateTime Deadline() => DateTime.UtcNow.AddSeconds(PatienceSeconds);

        /// <summary>Whether a test still waits for something; fails after the deadline.</summary>
        public static bool Awaits(bool isPending, DateTime deadline, string what)
        {
            if (isPending)
                Assert.That(DateTime.UtcNow, Is.LessThan(deadline), what + " took longer than anyone waits");
            return isPending;
        }

        public static int DrawnNodes() => (PointCloudSystemGroup.ObjectWorld ?? World.DefaultGameObjectInjectionWorld)
            ?.GetExistingSystemManaged<PointCloudSystemGroup>()?.Stats.DrawnNodes ?? 0;

        public static int CloudFiles() => Count(ComponentType.ReadOnly<PointCloudFile>());

        public static EnterPlayMode EnterPlayMode() => new EnterPlayMode(!EditorSettings.enterPlayModeOptionsEnabled ||
            (EditorSettings.enterPlayModeOptions & EnterPlayModeOptions.DisableDomainReload) == 0);

        static int Count(params ComponentType[] types)
        {
            var world = PointCloudSystemGroup.ObjectWorld ?? World.DefaultGameObjectInjectionWorld;
            if (world == null || !world.IsCreated)
                return 0;
            using var query = world.EntityManager.CreateEntityQuery(types);
            return query.CalculateEntityCount();
        }

        static void DeleteConverted(string asset)
        {
            try
            {
                if (AssetDatabase.LoadAssetAtPath<PointCloudAsset>(asset) == null)
                    return;
                string folder = Imports.Paths.Absolute(Imports.HandleOf(asset).CloudPath);
                if (folder.StartsWith(Imports.Paths.Clouds, StringComparison.Ordinal) && Directory.Exists(folder))
                    CloudCatalog.Delete(folder);
            }
            catch (PointCloudException)
            {
                // A handle that a test has damaged names no folder.
            }
        }
    }
}
