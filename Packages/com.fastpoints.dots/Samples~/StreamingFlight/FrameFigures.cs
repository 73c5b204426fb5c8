using System.Globalization;
using FastPoints.Entities;
using FastPoints.Streaming;
using Unity.Entities;
using UnityEngine;

namespace FastPoints.Samples.StreamingFlight
{
    /// <summary>Shows on the screen what the last frame streamed and drew for all clouds.</summary>
    [AddComponentMenu("FastPoints/Samples/Frame Figures")]
    public sealed class FrameFigures : MonoBehaviour
    {
        void OnGUI()
        {
            if (TryGetFigures(out var stats))
                GUILayout.Label(Describe(stats));
        }

        /// <summary>False until the world streams.</summary>
        public static bool TryGetFigures(out FrameStats stats)
        {
            var world = PointCloudSystemGroup.ObjectWorld ?? World.DefaultGameObjectInjectionWorld;
            var group = world?.GetExistingSystemManaged<PointCloudSystemGroup>();
            bool isStreaming = group?.Stream != null;
            stats = isStreaming ? group.Stats : default;
            return isStreaming;
        }

        public static string Describe(in FrameStats stats) => string.Format(CultureInfo.InvariantCulture,
            "{0:N0} points in {1} nodes drawn, {2:N0} selected\n{3:0.0} MB in graphics memory, {4:0.0} KB " +
                "copied, {5} reads under way\n" +
            "{6:0.00} ms of the main thread (select {7:0.00})", stats.DrawnPoints, stats.DrawnNodes, stats.SelectedPoints,
            stats.PoolBytes / 1e6, stats.UploadedBytes / 1e3, stats.ReadsInFlight, stats.TotalMs, stats.SelectMs);
    }
}
