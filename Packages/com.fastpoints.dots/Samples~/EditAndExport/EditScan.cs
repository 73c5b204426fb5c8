using System.Collections.Generic;
using System.IO;
using FastPoints.Entities;
using FastPoints.Export;
using FastPoints.Store;
using UnityEngine;

namespace FastPoints.Samples.EditAndExport
{
    /// <summary>Edits a converted cloud from a script, with three buttons: deletes the points in the middle of it, undoes that,
    /// and exports what is left. What is shown follows by itself.</summary>
    [RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Samples/Edit Scan")]
    public sealed class EditScan : MonoBehaviour
    {
        [Range(0, 1)]
        [Tooltip("How much of the cloud's length and width the middle is.")]
        public float Middle = 0.3f;

        [Range(1, 30)]
        [Tooltip("Time of the main thread in each frame, in ms.")]
        public float FrameMs = 4;

        JobCoroutine m_work;

        /// <summary>One line for the user.</summary>
        public string Status { get; private set; } = "";

        public bool IsBusy => m_work != null && !m_work.IsDone;

        void OnDisable() => m_work?.Cancel();

        void Update()
        {
            try
            {
                if (IsBusy)
                    m_work.Tick(FrameMs);
            }
            catch (PointCloudException e)
            {
                Status = e.Message;
            }
        }

        void OnGUI()
        {
            if (GUILayout.Button("Delete the middle") && !IsBusy)
                m_work = new JobCoroutine(DeleteMiddle(FullPath));
            if (GUILayout.Button("Undo") && !IsBusy)
                m_work = new JobCoroutine(PointCloudEdits.Undo(FullPath, isUndone =>
                    Status = isUndone ? "undone" : "there is nothing to undo"));
            if (GUILayout.Button("Export") && !IsBusy)
                m_work = new JobCoroutine(Export(FullPath));
            GUILayout.Label(IsBusy ? "working" : Status);
        }

        string FullPath
        {
            get
            {
                var cloud = GetComponent<PointCloud>();
                return cloud.Cloud != null ? cloud.Cloud.Paths.FullPath : cloud.Path;
            }
        }

        IEnumerator<JobStep> DeleteMiddle(string path)
        {
            BoundsGeo middle = default;
            // A disk may be slow: not in a frame.
            yield return JobStep.Of(PoolTask.Run(path, () => BoundsOf(path), bounds => middle = bounds));
            var margin = middle.Size * (1 - Middle) / 2;
            (margin.z, middle.Min, middle.Max) = (0, middle.Min + margin, middle.Max - margin);
            yield return JobStep.Of(PointCloudEdits.DeleteIn(path, middle, points => Status = points + " points deleted"));
        }

        IEnumerator<JobStep> Export(string path)
        {
            string target = Path.Combine(Application.persistentDataPath, "edited.laz");
            return PointCloudEdits.Export(path, target, points => Status = points + " points in " + target);
        }

        static BoundsGeo BoundsOf(string path)
        {
            using var folder = CloudFolder.Open(path);
            return folder.Manifest.BoundsGeo;
        }
    }
}
