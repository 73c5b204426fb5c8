using FastPoints.Feeds;
using UnityEngine;

namespace FastPoints.SourceFeeds
{
    /// <summary>
    /// Has clouds read from LAS, LAZ, PLY, E57, text, COPC, Potree and EPT where they are not converted. In an editor they always
    /// are; a player has the readers where its code uses this assembly, or where a scene has this component.
    /// </summary>
    [AddComponentMenu("FastPoints/Point File Readers")]
    [DisallowMultipleComponent]
    public sealed class PointFileReaders : MonoBehaviour
    {
        /// <summary>Also with domain reload off: twice is as once.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Register() => CloudFeeds.Register(SourceFeed.Open);

        void Awake() => Register();
    }
}
