using FastPoints.Drawing;
using UnityEngine;

namespace FastPoints.Sources
{
    /// <summary>Makes clouds in LAS, LAZ, PLY, E57, text, COPC, Potree and EPT readable without conversion. In an editor they
    /// always are; a player has the readers if its code uses this assembly, or if a scene has this component.</summary>
    [AddComponentMenu("FastPoints/Point File Readers")]
    [DisallowMultipleComponent]
    [HelpPage("run-time")]
    [Icon("Packages/com.fastpoints.dots/Editor/Icons/PointCloud.png")]
    public sealed class PointFileReaders : MonoBehaviour
    {
        /// <summary>Works with domain reload off, too: registering twice is harmless.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Register() => CloudFeeds.Register(paths => new SourceFeed(PointReaders.Open(paths)));

        void Awake() => Register();
    }
}
