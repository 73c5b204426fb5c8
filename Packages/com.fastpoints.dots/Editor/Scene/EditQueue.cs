using System;
using System.Collections.Generic;
using FastPoints.Export;
using FastPoints.Store;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Edits clouds one operation after the other, beside the editor's own work. Each becomes a step of Undo: undoing it
    /// undoes it in the cloud's journal.</summary>
    [InitializeOnLoad]
    internal static class EditQueue
    {
        const double UpdateMs = 4;

        static readonly Queue<(string Cloud, IEnumerator<JobStep> Work)> s_waiting = new Queue<(string, IEnumerator<JobStep>)>();
        static JobCoroutine s_running;
        static string s_cloud;

        static EditQueue()
        {
            if (!AssetDatabase.IsAssetImportWorkerProcess())
                Listen();
        }

        internal static void Listen()
        {
            EditorApplication.update += Update;
            AssemblyReloadEvents.beforeAssemblyReload += Cancel;
            EditorApplication.quitting += Cancel;
            Undo.undoRedoPerformed += Follow;
        }

        public static bool IsBusy => s_running != null || s_waiting.Count > 0;

        // The draft is shown until the operation is.
        public static void Begin(string cloud, EditOperation operation, EditOperation draft, string name) =>
            s_waiting.Enqueue((cloud, Run(cloud, operation, draft, name)));

        static void Update()
        {
            if (s_running == null && s_waiting.Count > 0)
            {
                var (cloud, work) = s_waiting.Dequeue();
                (s_cloud, s_running) = (cloud, new JobCoroutine(work));
            }
            try
            {
                if (s_running == null || !s_running.Tick(UpdateMs))
                    return;
            }
            catch (Exception e)
            {
                Debug.LogError("FastPoints: " + PointCloudException.Of(s_cloud, e).FullMessage);
            }
            s_running = null;
            EditModeFrames.RequestFrame();
        }

        static IEnumerator<JobStep> Run(string cloud, EditOperation operation, EditOperation draft, string name)
        {
            int before = 0, after = 0;
            try
            {
                yield return JobStep.Of(PoolTask.Run(cloud, () => EditCloud.GoTo(cloud, -1), count => before = count));
                yield return JobStep.Of(EditCloud.Run(cloud, operation, null));
                yield return JobStep.Of(PoolTask.Run(cloud, () => EditCloud.GoTo(cloud, -1), count => after = count));
            }
            finally
            {
                // It changed nothing, or failed.
                if (draft != null && EditJournal.DraftAt(EditJournal.PathOf(cloud)) == draft)
                    EditJournal.SetDraft(null, null);
            }
            if (after == before)
                yield break;
            var applied = AppliedEditCounts.instance;
            applied.Set(cloud, before);
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(applied, name);
            applied.Set(cloud, after);
        }

        static void Follow()
        {
            foreach (var (cloud, count) in AppliedEditCounts.instance.TakeChanged())
                s_waiting.Enqueue((cloud, PoolTask.Run(cloud, () => EditCloud.GoTo(cloud, count),
                    moved => AppliedEditCounts.instance.Set(cloud, moved))));
        }

        static void Cancel()
        {
            s_running?.Cancel();
            s_running = null;
            s_waiting.Clear();
        }
    }
}
