using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Entities;
using FastPoints.Export;
using FastPoints.Reading;
using FastPoints.Streaming;
using Unity.Entities;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The menu <em>GameObject > Point Cloud > Export Selection...</em>: what the scene's clip boxes and the
    /// shown classes keep of the selected cloud, in the cloud's own coordinates, as LAZ.</summary>
    internal static class SceneExport
    {
        const string Menu = "GameObject/Point Cloud/Export Selection...";

        [MenuItem(Menu, false, 30)]
        static void Prompt()
        {
            string folder = EditorUtility.OpenFolderPanel("Export selected points into a folder", "", "");
            if (!string.IsNullOrEmpty(folder))
                Begin(Selected, PointCloudImports.Current, folder);
        }

        [MenuItem(Menu, true, 30)]
        static bool CanExport() => Selected != null;

        internal static PointCloud Selected =>
            Selection.activeObject is GameObject selected ? selected.GetComponent<PointCloud>() : null;

        /// <returns>The file, which is there when the export has ended; null if it cannot begin, which is logged.</returns>
        internal static string Begin(PointCloud cloud, EditorImports imports, string folder)
        {
            var shown = FindStreamed(cloud, out var clips);
            if (shown == null)
            {
                Debug.LogError("FastPoints: " + cloud.gameObject.name + " is not shown yet: nothing says where its points are");
                return null;
            }
            try
            {
                var sources = SourcesOf(cloud, shown, imports);
                var taken = new List<string>(Directory.GetFileSystemEntries(folder));
                taken.AddRange(imports.Exports.ReservedPaths);
                string path = new FreePaths(folder, ".laz", taken).Next(cloud.gameObject.name);
                imports.Exports.Begin(sources, path, new ExportSettings
                {
                    Clips = clips,
                    GeoToWorld = GeoToWorld(shown),
                    Classes = ClassesExcept(cloud.HiddenClasses),
                    InFlightMs = 50,
                });
                return path;
            }
            catch (Exception e) when (e is PointCloudException || FileFailures.IsFileFailure(e))
            {
                Debug.LogError("FastPoints: " + e.Message);
                return null;
            }
        }

        /// <summary>The cloud as it is streamed; null if it is not.</summary>
        internal static StreamedCloud FindStreamed(PointCloud cloud, out ClipBox[] clips)
        {
            clips = null;
            var group = PointCloudSystemGroup.ObjectGroup;
            if (group?.Stream == null || cloud.Entity == Entity.Null ||
                !group.World.EntityManager.HasComponent<StreamedPointCloud>(cloud.Entity))
                return null;
            clips = group.Stream.ClipBoxes.AsArray().ToArray();
            return group.Stream.Clouds[group.World.EntityManager.GetComponentData<StreamedPointCloud>(cloud.Entity).Number];
        }

        /// <summary>The converted cloud that is shown, or the files that it is made of.</summary>
        static IReadOnlyList<string> SourcesOf(PointCloud cloud, StreamedCloud shown, EditorImports imports)
        {
            if (shown.Source is FolderSource stored && !stored.Folder.IsUnfinished)
                return new[] { stored.Folder.FolderPath };
            if (cloud.Cloud == null)
                return new[] { cloud.Path };
            return imports.HandleOf(AssetDatabase.GetAssetPath(cloud.Cloud)).Sources.ConvertAll(imports.Paths.Absolute);
        }

        /// <summary>A cloud is placed from the corner of its root cube.</summary>
        static CloudPlacement GeoToWorld(StreamedCloud shown)
        {
            var corner = shown.Source.Grid.ToGeo(shown.Source.Root.Corner);
            return new CloudPlacement(shown.Placement.Linear,
                shown.Placement.OriginWorld - math.mul(shown.Placement.Linear, corner));
        }

        /// <returns>Null for all.</returns>
        static int[] ClassesExcept(int[] hidden)
        {
            if (hidden.Length == 0)
                return null;
            var shown = new List<int>();
            for (int c = 0; c <= byte.MaxValue; c++)
                if (Array.IndexOf(hidden, c) < 0)
                    shown.Add(c);
            return shown.ToArray();
        }
    }
}
