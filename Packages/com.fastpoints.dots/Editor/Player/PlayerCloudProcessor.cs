using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Entities;
using FastPoints.Store;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace FastPoints.Editor
{
    /// <summary>Adds the clouds of a player (<see cref="PlayerAssets"/>) to its streaming assets, and reports their sizes:
    /// converted ones, and those that can be streamed directly. Any other cloud fails the build: the player would show
    /// nothing.</summary>
    internal sealed class PlayerCloudProcessor : BuildPlayerProcessor
    {
        public override int callbackOrder => 1; // After Entities, which saves changed scenes.

        public override void PrepareForBuild(BuildPlayerContext buildPlayerContext)
        {
            var clouds = new PlayerClouds();
            string[] scenes = PlayerAssets.ScenesOf(buildPlayerContext.BuildPlayerOptions);
            FailBuildIfItThrows(() => Add(PlayerAssets.Of(scenes), clouds));
            Check(clouds, buildPlayerContext.BuildPlayerOptions.target);
            PlayerReaderLinker.s_areNeeded = clouds.HasSources;
            foreach (var entry in clouds.Entries)
                buildPlayerContext.AddAdditionalPathToStreamingAssets(entry.DiskPath, entry.PlayerPath);
            if (clouds.Entries.Count > 0)
                Debug.Log(clouds.Report());
            else if (AssetDatabase.FindAssets("t:" + nameof(PointCloudAsset)).Length is var known && known > 0)
                Debug.LogWarning("FastPoints: no point cloud in the player, of " + known + " in the project: neither " +
                    (scenes.Length > 0 ? string.Join(", ", scenes) : "a scene") + " nor a folder Resources refers to one. " +
                    "Those that only code names go into Always in players, in Project Settings > FastPoints.");
        }

        static void Add(HashSet<string> assets, PlayerClouds clouds)
        {
            foreach (string path in assets)
            {
                // Textures and meshes that scenes refer to are not loaded for this.
                if (AssetDatabase.GetMainAssetTypeAtPath(path) != typeof(PointCloudAsset))
                    continue;
                var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(path);
                string folder = PointCloudImports.Current.Paths.Absolute(asset.ProjectPath ?? "");
                if (string.IsNullOrEmpty(asset.PlayerSource) || CloudFolder.IsCloud(folder))
                    clouds.Add(path, folder, asset.PlayerPath, PointCloudImports.Current.HandleOf(path).CloudId);
                else
                    clouds.AddSource(path, asset.Paths.FullSources()[0], asset.PlayerSource, asset.Points);
            }
        }

        internal static void FailBuildIfItThrows(Action step)
        {
            try
            {
                step();
            }
            catch (PointCloudException e)
            {
                throw new BuildFailedException(e.Message + (e.Code == FailureCode.NotFound
                    ? ". FastPoints > Clouds converts what is missing, and locates sources" : ""));
            }
            catch (InvalidOperationException e)
            {
                throw new BuildFailedException(e.Message);
            }
        }

        static void Check(PlayerClouds clouds, BuildTarget target)
        {
            if (clouds.Entries.Count > 0 && target == BuildTarget.WebGL)
                throw new BuildFailedException("FastPoints: players for " + target + " cannot open point clouds in their " +
                    "streaming assets, " + clouds.Entries[0].PlayerPath + " for one: take them out of the scenes, and see " +
                    "Limits in the manual");
            int limitMiB = FastPointsSettings.instance.PlayerWarningMiB;
            if (limitMiB > 0 && clouds.Bytes >= (long)limitMiB << 20)
                Debug.LogWarning("FastPoints: the player's point clouds have " + (clouds.Bytes >> 20) + " MiB. Project " +
                    "Settings > FastPoints says from where on this is told");
        }
    }

    /// <summary>Converts in batch mode: a build server has sources and no user. Before Entities, which bakes
    /// subscenes from the handles.</summary>
    internal sealed class BatchCloudProcessor : BuildPlayerProcessor
    {
        public override int callbackOrder => -1;

        public override void PrepareForBuild(BuildPlayerContext buildPlayerContext)
        {
            if (Application.isBatchMode)
                PlayerCloudProcessor.FailBuildIfItThrows(() => BatchConvert.Convert(PointCloudImports.Current,
                    PlayerAssets.Of(PlayerAssets.ScenesOf(buildPlayerContext.BuildPlayerOptions))));
        }
    }

    /// <summary>Makes code stripping keep the readers of point cloud files if a player has clouds that are not converted: nothing
    /// else in it refers to them.</summary>
    internal sealed class PlayerReaderLinker : IUnityLinkerProcessor
    {
        const string LinkXml = "<linker>\n" + "  <assembly fullname=\"FastPoints.Import\">\n" +
            "    <type fullname=\"FastPoints.Sources.PointFileReaders\" preserve=\"all\" />\n" +
            "  </assembly>\n" +
            "</linker>\n";

        internal static bool s_areNeeded;

        public int callbackOrder => 0;

        /// <returns>The file's absolute path; null for none.</returns>
        public string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data)
        {
            if (!s_areNeeded)
                return null;
            string path = PointCloudImports.ConfiguredPaths.Absolute("Library/FastPoints/link.xml");
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, LinkXml);
            return path;
        }
    }

    static class PlayerAssets
    {
        static readonly string[] s_ofResources = { "t:" + nameof(PointCloudAsset), "t:Prefab" };

        /// <summary>The scenes that a player is built from: if none are named, Unity builds the open one.</summary>
        /// <returns>Their paths; empty for an open scene that was never saved, which Entities does not build.</returns>
        public static string[] ScenesOf(BuildPlayerOptions options)
        {
            if (options.scenes != null && options.scenes.Length > 0)
                return options.scenes;
            string open = SceneManager.GetActiveScene().path;
            return string.IsNullOrEmpty(open) ? Array.Empty<string>() : new[] { open };
        }

        /// <summary>The assets that scenes refer to, clouds and prefabs that Unity adds to any player, and clouds that the
        /// project's settings name.</summary>
        /// <returns>Their paths.</returns>
        public static HashSet<string> Of(string[] scenes)
        {
            var roots = new List<string>(scenes);
            foreach (string type in s_ofResources)
                foreach (string guid in AssetDatabase.FindAssets(type))
                {
                    string path = AssetDatabase.GUIDToAssetPath(guid);
                    if (path.IndexOf("/Resources/", StringComparison.Ordinal) >= 0)
                        roots.Add(path);
                }
            foreach (string guid in FastPointsSettings.instance.AlwaysInPlayers)
            {
                string path = AssetDatabase.GUIDToAssetPath(guid);
                if (AssetDatabase.GetMainAssetTypeAtPath(path) == typeof(PointCloudAsset))
                    roots.Add(path);
                else
                    Debug.LogWarning("FastPoints: Always in players, in Project Settings > FastPoints, names a cloud that the " +
                        "project does not have: " + (string.IsNullOrEmpty(path) ? guid : path));
            }
            return new HashSet<string>(AssetDatabase.GetDependencies(roots.ToArray(), true));
        }
    }
}
