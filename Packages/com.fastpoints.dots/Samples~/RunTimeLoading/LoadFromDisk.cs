using System.Collections.Generic;
using System.Globalization;
using System.IO;
using FastPoints.Build;
using FastPoints.Entities;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using UnityEngine;

namespace FastPoints.Samples.RunTimeLoading
{
    /// <summary>Shows a file that the player finds on disk: it converts the file once, a few milliseconds a frame, into the
    /// application's own data, and shows it from there. Finished parts are shown meanwhile; an interrupted conversion is
    /// continued.</summary>
    [RequireComponent(typeof(PointCloud))]
    [AddComponentMenu("FastPoints/Samples/Load From Disk")]
    public sealed class LoadFromDisk : MonoBehaviour
    {
        [Tooltip("LAS, LAZ, COPC, PLY, E57 or text, or a folder; the sample's street where this is empty.")]
        public string Source;

        [Tooltip("A LAZ file in the player, which is loaded where no source is named.")]
        public TextAsset Street;

        [Range(1, 30)]
        [Tooltip("Time of the main thread in each frame, in ms.")]
        public float FrameMs = 4;

        readonly StageProgress m_progress = new StageProgress();
        JobCoroutine m_coroutine;
        string m_target;

        /// <summary>One line for the user.</summary>
        public string Status { get; private set; } = "";

        public bool IsDone { get; private set; }

        void OnEnable()
        {
            IsDone = false;
            m_coroutine = new JobCoroutine(Load());
        }

        void OnDisable() => m_coroutine.Cancel();

        void Update()
        {
            if (m_coroutine.IsDone)
                return;
            try
            {
                IsDone = m_coroutine.Tick(FrameMs);
            }
            catch (PointCloudException e)
            {
                // The file is at fault: the message has its name, the byte, what was expected and what was found.
                Status = e.Message;
                Debug.LogError(e.FullMessage);
                return;
            }
            var cloud = GetComponent<PointCloud>();
            // Switches as soon as the new folder can be opened, and once more when it is complete.
            if (m_target != null && cloud.Path != m_target && CloudFolder.IsCloud(m_target))
                cloud.Path = m_target;
            else if (IsDone)
                cloud.Reopen();
            Status = IsDone
                ? m_target
                : string.Format(CultureInfo.InvariantCulture, "{0} {1:0} %", m_progress.Current, m_progress.Fraction * 100);
        }

        void OnGUI() => GUILayout.Label(Status);

        IEnumerator<JobStep> Load()
        {
            bool isStreet = string.IsNullOrEmpty(Source);
            string source = isStreet ? Path.Combine(Application.temporaryCachePath, "street.laz") : Source;
            m_target = Path.Combine(Application.persistentDataPath, CloudName.Of(source) + StoreFormat.FolderExtension);
            // The folder has this name only when it is complete.
            if (Directory.Exists(m_target))
                yield break;
            if (isStreet)
                File.WriteAllBytes(source, Street.bytes);
            // Opening on another thread keeps a slow disk from stopping frames.
            using var opening = PoolTask.Begin(source, () => PointReaders.Open(source), unwanted => unwanted.DisposeUnread());
            while (!opening.IsDone)
                yield return default;
            using var reader = opening.Take();
            var settings = new ConvertSettings { KeepUnfinished = true };
            yield return JobStep.Of(ConvertCloud.Run(new[] { reader }, m_target, settings, _ => { }, m_progress));
        }
    }
}
