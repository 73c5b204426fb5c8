using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Core;
using FastPoints.Entities;
using FastPoints.Scenes;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The menu item <em>Assets > Import sample point cloud</em>: a seeded scan of a street, for samples and for users
    /// without a scan at hand. It is made in slices beside other work, then imported like any other file.</summary>
    internal static class SampleScan
    {
        public const string AssetPath = "Assets/street.pointcloud";

        /// <summary>This makes 36 MB of LAS.</summary>
        public const int Points = 1_000_000;

        const uint Seed = 1;
        const double UpdateMs = 4;

        static readonly List<Action<PointCloudAsset>> s_waiting = new List<Action<PointCloudAsset>>();
        static readonly StageProgress s_stage = new StageProgress();
        static JobCoroutine s_coroutine;
        static int s_progress;

        [MenuItem("Assets/Import sample point cloud", false, 21)]
        static void Import() => Get(asset => Selection.activeObject = asset);

        /// <summary>Gets the sample's asset, which is made first if it does not exist.</summary>
        /// <param name="done">Called on the main thread: at once if the asset exists, and not at all if it cannot be
        /// made.</param>
        public static void Get(Action<PointCloudAsset> done)
        {
            var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(AssetPath);
            // A clone of the project has the asset alone.
            if (asset != null && (File.Exists(SourcePath) ||
                CloudFolder.IsCloud(PointCloudImports.Current.Paths.Absolute(asset.ProjectPath))))
            {
                done(asset);
                return;
            }
            s_waiting.Add(done);
            if (s_coroutine == null)
                Begin();
        }

        static string SourcePath => PointCloudImports.Current.Paths.Absolute(ProjectPaths.DefaultClouds + "/street.las");

        static void Begin()
        {
            string path = SourcePath;
            try
            {
                PointCloudImports.Current.CreateFolder(Path.GetDirectoryName(path));
                Directory.CreateDirectory(Path.GetDirectoryName(path));
            }
            catch (Exception e)
            {
                LogError(e);
                s_waiting.Clear();
                return;
            }
            s_coroutine = new JobCoroutine(File.Exists(path) ? Nothing() : LasScan.Run(path, Points, Seed, progress: s_stage));
            s_progress = Progress.Start("Scan a street", null, Progress.Options.Managed);
            Progress.RegisterCancelCallback(s_progress, () =>
            {
                End();
                return true;
            });
            EditorApplication.update += Update;
            AssemblyReloadEvents.beforeAssemblyReload += Cancel;
            EditorApplication.quitting += Cancel;
        }

        static IEnumerator<JobStep> Nothing()
        {
            yield break;
        }

        static void LogError(Exception e) => Debug.LogError("FastPoints: " + PointCloudException.Of(SourcePath, e).FullMessage);

        static void Update()
        {
            bool isDone;
            try
            {
                isDone = s_coroutine.Tick(UpdateMs);
            }
            catch (Exception e)
            {
                // Whatever it is: the next update would throw it again, and the next request would wait for ever.
                LogError(e);
                Progress.Finish(s_progress, Progress.Status.Failed);
                End();
                return;
            }
            Progress.Report(s_progress, (float)s_stage.Share, null);
            if (!isDone)
                return;
            Progress.Finish(s_progress);
            var waiting = s_waiting.ToArray();
            End();
            var asset = AssetDatabase.LoadAssetAtPath<PointCloudAsset>(AssetPath);
            if (asset != null)
                PointCloudImports.Current.Convert(AssetPath);
            else
                asset = PointCloudImports.Current.CreateAsset(SourcePath, Path.GetDirectoryName(AssetPath));
            if (asset != null)
                foreach (var done in waiting)
                    done(asset);
        }

        static void Cancel()
        {
            Progress.Finish(s_progress, Progress.Status.Canceled);
            End();
        }

        /// <summary>Ends the scan; an incomplete one leaves no file.</summary>
        static void End()
        {
            EditorApplication.update -= Update;
            AssemblyReloadEvents.beforeAssemblyReload -= Cancel;
            EditorApplication.quitting -= Cancel;
            s_coroutine.Cancel();
            s_coroutine = null;
            s_waiting.Clear();
        }
    }
}
